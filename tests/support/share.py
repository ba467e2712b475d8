"""What an ordinary run of the tests leaves to others, as in share.hpp: one in so many of what is alike, another one with each
commit (GRADUS_SHARE); all of it with GRADUS_ALL (`./bootstrap test --all`)."""
import os

import programs

programs.use_nothing_else()
EVERYTHING = bool(os.environ.get("GRADUS_ALL") or os.environ.get("GRADUS_STRESS"))
SHARE = int(os.environ.get("GRADUS_SHARE") or 0)


def in_share(i, parts):
    """Whether the i-th of many alike belongs to this run."""
    return EVERYTHING or (i + SHARE) % parts == 0


def share_of(items, parts):
    """Those of them that do; at least one where there are any."""
    items = list(items)
    return [item for i, item in enumerate(items) if in_share(i, parts)] or items[:1]
