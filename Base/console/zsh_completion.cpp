#include "Base/console/shell_completion.h"
#include "Base/names/words.h"

namespace base {
namespace {

// A text in single quotes within a specification of _arguments or _values, where some letters mean something.
std::string escaped(const std::string& text) {
  std::string result;
  for (const char letter : text) {
    if (letter == '[' || letter == ']' || letter == ':' || letter == '\\') result += '\\';
    result += letter == '\'' ? "'\\''" : std::string(1, letter);
  }
  return result;
}

// The function that completes the key=value words of a command's function `name`.
std::string key_function(const Argument& argument, const std::string& name) {
  std::string text = name + "_keys() {\n  _values -S = option";
  for (const OptionSpec& spec : argument.assigns) {
    const std::string words = std::holds_alternative<bool>(spec.default_value) ? "true false" : joined(spec.words);
    text += " \\\n    '" + spec.key + "[" + escaped(spec.summary) + "]:value:(" + words + ")'";
  }
  return text + "\n}\n\n";
}

// The action part of a specification of _arguments; `name`: the command's function.
std::string action(const Argument& argument, const std::string& name) {
  if (!argument.assigns.empty()) return name + "_keys";
  const bool commas = argument.is_list() && argument.list == Argument::List::commas;
  const std::string names = joined(argument.names);
  const std::string paths = argument.offers == Argument::Offers::folders ? "_files -/" : "_files";
  if (argument.offers == Argument::Offers::names) {
    if (names.empty()) return " ";
    return commas ? "{ _values -s , names " + names + " }" : "(" + names + ")";
  }
  return names.empty() ? paths : "{ compadd -- " + names + "; " + paths + " }";
}

std::string specification(const Argument& argument, const std::string& name) {
  const std::string help = escaped(argument.help);
  if (argument.positional())
    return "'" + std::string(argument.is_list() ? "*" : "") + ":" + argument.name + ":" + action(argument, name) + "'";
  std::string text = "'";
  if (!argument.excludes.empty()) text += "(" + joined(argument.excludes) + ")";
  if (argument.is_list()) text += "*";
  text += argument.name + "[" + help + "]";
  const int values = argument.flag() ? 0 : std::max(1, argument.count);
  for (int i = 0; i < values; ++i) text += ":value:" + action(argument, name);
  return text + "'";
}

// A function a command: `name` is "_foamsim_study_modes"; those of the commands within come first.
std::string functions(const Command& command, const std::string& name, bool outermost) {
  std::string text, list, cases, arguments;
  for (const auto& sub : command.commands()) {
    if (sub->hidden()) continue;
    const std::string function = name + "_" + sub->name();
    text += functions(*sub, function, false);
    list += "    '" + sub->name() + ":" + escaped(sub->summary()) + "'\n";
    cases += "        " + sub->name() + ") " + function + " ;;\n";
  }
  arguments = " \\\n    '(- *)--help[this help]'";
  if (outermost) arguments += " \\\n    '(- *)--version[the version]'";
  for (const Argument& argument : command.arguments()) {
    arguments += " \\\n    " + specification(argument, name);
    if (!argument.assigns.empty()) text += key_function(argument, name);
  }
  text += name + "() {\n";
  if (list.empty()) return text + "  _arguments -S" + arguments + "\n}\n\n";
  return text + "  local curcontext=$curcontext state line\n  local -a commands=(\n" + list + "  )\n" +
         "  _arguments -C -S" + arguments + " \\\n    '1: :->command' '*:: :->rest'\n" +
         "  case $state in\n    command) _describe command commands ;;\n    rest)\n      case $words[1] in\n" + cases +
         "      esac ;;\n  esac\n}\n\n";
}

}  // namespace

std::string zsh_completion(const CommandLine& line) {
  return "#compdef " + line.name() + "\n# zsh completion for " + line.name() + ", written by '" + line.name() +
         " generate zsh'\n\n" + functions(line.root(), "_" + line.name(), true) + "_" + line.name() + " \"$@\"\n";
}

}  // namespace base
