# Completion of the gradus command in fish; `gradus completion fish` prints it.
# What may come next is asked of the program itself, so that it always knows its own topics and flags.

function __gradus_next
    set -l words (commandline -opc)
    set -l typed (commandline -ct)
    set -l program $words[1]
    set -e words[1]
    # Of --output=FILE the part behind = is the file
    set -l flag (string match -r -- '^--[^=]*=' "$typed")
    set -l file (string replace -r -- '^--[^=]*=' '' "$typed")
    for line in ($program completion --next -- $words "$typed" 2>/dev/null)
        set -l parts (string split \t -- $line)
        if test -n "$parts[1]"
            echo $line
            continue
        end
        set -l paths (__fish_complete_directories "$file")
        if test "$parts[2]" = files -a (count $parts) -lt 3
            set paths (__fish_complete_path "$file")
        end
        for ending in (string split ' ' -- $parts[3])
            set -a paths $file*$ending
        end
        for path in $paths
            echo "$flag$path"
        end
    end
end

complete -c gradus -f -a '(__gradus_next)'
