#include <algorithm>

#include "Base/console/shell_completion.h"
#include "Base/names/words.h"

namespace base {
namespace {

// What does not depend on the program. The line is taken apart here, because bash breaks words at '=' as well; what it
// takes for the present word is then cut off the front of the replies.
constexpr const char* machinery = R"(
_SELF_words() {  # the words in $1 that begin like the present one; after commas where $2 is "list"
  local before=
  [[ $2 == list && $current == *,* ]] && before=${current%,*},
  local word
  for word in $1; do
    [[ $before$word == "$current"* ]] && COMPREPLY+=("$before$word")
  done
}

_SELF_paths() {  # file names, or folders where $1 is -d
  local IFS=$'\n'
  compopt -o filenames 2>/dev/null
  COMPREPLY+=($(compgen "$1" -- "$current"))
}

_SELF_assignment() {  # key=value, with the keys in $1; values by _SELF_values
  if [[ $current == *=* ]]; then
    local key=${current%%=*} before=
    [[ $current == *,* ]] && before=${current##*=} && before=${before%,*},
    local word
    for word in $(_SELF_values "${key%+}"); do
      [[ $key=$before$word == "$current"* ]] && COMPREPLY+=("$key=$before$word")
    done
  else
    compopt -o nospace 2>/dev/null
    local word
    for word in $1; do
      [[ $word == "$current"* ]] && COMPREPLY+=("$word=")
    done
  fi
}

_SELF() {
  local line=${COMP_LINE:0:COMP_POINT} words current previous command= word
  read -ra words <<< "$line"
  [[ $line == *[[:space:]] ]] && words+=("")
  local last=$((${#words[@]} - 1))
  current=${words[last]} previous=${words[last - 1]}
  for word in "${words[@]:1:last - 1}"; do
    _SELF_is_command "$command $word" && command="$command $word"
  done
  COMPREPLY=()
  if [[ $current == --*=* ]]; then
    previous=${current%%=*} current=${current#*=}
  fi
  _SELF_argument "$command" "$previous" || _SELF_others "$command"
  if [[ $COMP_WORDBREAKS == *=* && $current == *=* ]]; then
    COMPREPLY=("${COMPREPLY[@]#"${current%"${current##*=}"}"}")
  fi
}

complete -F _SELF )";

std::string keys_of(const Argument& argument) {
  std::vector<std::string> keys;
  for (const OptionSpec& spec : argument.assigns) keys.push_back(spec.key);
  return joined(keys);
}

// What completes a value of the argument.
std::string completes(const Argument& argument) {
  if (!argument.assigns.empty()) return "_SELF_assignment '" + keys_of(argument) + "'";
  std::string text;
  if (!argument.names.empty())
    text = "_SELF_words '" + joined(argument.names) + "'" +
           (argument.is_list() && argument.list == Argument::List::commas ? " list" : "");
  if (argument.offers != Argument::Offers::names)
    text += std::string(text.empty() ? "" : "; ") + "_SELF_paths " +
            (argument.offers == Argument::Offers::files ? "-f" : "-d");
  return text.empty() ? ":" : text;
}

// The cases of all commands and what is within them, `path` being " study modes".
struct Cases {
  std::string commands, arguments, others;
  std::vector<const OptionSpec*> keys;

  void add(const Command& command, const std::string& path) {
    if (!path.empty()) commands += "    '" + path + "') ;;\n";
    std::vector<std::string> options{"--help"}, subcommands;
    std::string positionals;
    for (const Argument& argument : command.arguments()) {
      for (const OptionSpec& spec : argument.assigns)
        if (std::ranges::find(keys, spec.key, &OptionSpec::key) == keys.end()) keys.push_back(&spec);
      if (argument.positional())
        positionals += "; " + completes(argument);
      else
        options.push_back(argument.name);
      if (!argument.positional() && !argument.flag())
        arguments += "    '" + path + " " + argument.name + "') " + completes(argument) + " ;;\n";
    }
    if (path.empty()) options.emplace_back("--version");
    for (const auto& sub : command.commands()) {
      if (sub->hidden()) continue;
      subcommands.push_back(sub->name());
      add(*sub, path + " " + sub->name());
    }
    if (!subcommands.empty()) positionals += "; _SELF_words '" + joined(subcommands) + "'";
    others += "    '" + path + "')\n      if [[ $current == -* ]]; then _SELF_words '" + joined(options) +
              "'; else :" + positionals + "; fi ;;\n";
  }

  std::string values() const {
    std::string text;
    for (const OptionSpec* spec : keys) {
      const std::string words = std::holds_alternative<bool>(spec->default_value) ? "true false" : joined(spec->words);
      if (!words.empty()) text += "    " + spec->key + ") echo '" + words + "' ;;\n";
    }
    return text;
  }
};

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
    text.replace(at, from.size(), to);
  return text;
}

}  // namespace

std::string bash_completion(const CommandLine& line) {
  Cases cases;
  cases.add(line.root(), "");
  // In the parts below _SELF stands for the functions' common name.
  const std::string script =
      "_SELF_is_command() {\n  case $1 in\n" + cases.commands + "    *) return 1 ;;\n  esac\n}\n\n" +
      "_SELF_argument() {  # command, option: completes the option's value\n  case \"$1 $2\" in\n" + cases.arguments +
      "    *) return 1 ;;\n  esac\n}\n\n" +
      "_SELF_others() {  # command: its options, and words without one\n  case $1 in\n" + cases.others +
      "  esac\n}\n\n" + "_SELF_values() {  # key: the words that it may have\n  case $1 in\n" + cases.values() +
      "  *) ;;\n  esac\n}\n";
  return "# bash completion for " + line.name() + ", written by '" + line.name() + " generate bash'\n\n" +
         replaced(script + machinery, "_SELF", "_" + line.name()) + line.name() + "\n";
}

}  // namespace base
