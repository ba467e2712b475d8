#pragma once
// Refusing: how a call ends that can't do what was asked. One function does it for the whole project, so that
// a build without exceptions (a page in a browser) can hand the text to its host.

#include <stdexcept>
#include <string>
#include <utility>

#include "core/language.hpp"

namespace gradus {

/// Thrown when an argument lies outside a function's documented domain.
class ContractViolation : public std::invalid_argument {
 public:
  using std::invalid_argument::invalid_argument;
};

/// What is wrong with a file the user gave: "name: what was expected, what was found".
class InputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// An argument that can't be taken: code that shows it puts the parameter's flag in front.
class ArgumentError : public std::runtime_error {
 public:
  ArgumentError(std::string name, const std::string& what_was_expected)
      : std::runtime_error(what_was_expected), parameter(std::move(name)) {}
  std::string parameter;
};

/// What was asked for can't be done: an unknown name, a flag's value that is none, two that exclude one
/// another. The text names the flag.
class UsageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// What is refused, and why.
struct Refusal {
  enum class Kind {
    contract,  ///< a caller's mistake: ContractViolation
    input,     ///< a file's: InputError
    argument,  ///< one of the arguments of a run: ArgumentError
    usage,     ///< all else that was asked for: UsageError
  };
  Kind kind;
  std::string text;         ///< one sentence
  std::string parameter{};  ///< of an argument: its name
};

/// Ends the call: throws the error of this kind, or, built without exceptions, hands the refusal to the host
/// (see set_refusal_handler) and does not return. No destructor runs then, so that nothing that the call was
/// at is good for another one.
[[noreturn]] void refuse(const Refusal& refusal);

[[noreturn]] inline void refuse_input(std::string text) { refuse({Refusal::Kind::input, std::move(text)}); }
[[noreturn]] inline void refuse_usage(std::string text) { refuse({Refusal::Kind::usage, std::move(text)}); }

/// What a build without exceptions calls before it stops. Default: writes the text to stderr.
using RefusalHandler = void (*)(const Refusal& refusal);
RefusalHandler set_refusal_handler(RefusalHandler handler) noexcept;

/// What calls work(data) in a build without exceptions where one may end with a contract that isn't kept
/// (keeps_contracts): whether it came to its end. It can tell where the host can leave the work in the midst,
/// as a page's can. Default: calls it, and a refusal ends the program as anywhere.
using AttemptHandler = bool (*)(void (*work)(void*), void* data);
AttemptHandler set_attempt_handler(AttemptHandler handler) noexcept;
bool attempted(void (*work)(void*), void* data);

}  // namespace gradus
