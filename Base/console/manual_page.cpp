#include "Base/console/manual_page.h"

#include <algorithm>

#include "Base/console/argument_values.h"

namespace base {
namespace {

// Text that troff prints as it is.
std::string plain(const std::string& text) {
  std::string result;
  for (const char letter : text) {
    const bool begins = result.empty() || result.back() == '\n';
    if (begins && (letter == '.' || letter == '\'')) result += "\\&";
    if (letter == '\\')
      result += "\\e";
    else if (letter == '-')
      result += "\\-";
    else
      result += letter;
  }
  return result;
}

std::string upper(std::string text) {
  std::ranges::transform(text, text.begin(), [](unsigned char letter) { return std::toupper(letter); });
  return text;
}

// A paragraph of what is printed bold, in italics, and indented below.
std::string entry(const std::string& bold, const std::string& italics, const std::string& text) {
  return ".TP\n\\fB" + plain(bold) + "\\fR" + (italics.empty() ? "" : " \\fI" + plain(italics) + "\\fR") + "\n" +
         plain(text) + "\n";
}

std::string help_of(const Argument& argument) {
  const std::string value = default_text(argument);
  return argument.help + (value.empty() ? "" : " (default: " + value + ")") + (argument.required ? " (required)" : "");
}

std::string synopsis(const Command& command, const std::string& name) {
  std::string text = ".B " + plain(name) + "\n";
  for (const Argument& argument : command.arguments())
    if (argument.positional())
      text += std::string("[\\fI") + plain(argument.name) + "\\fR" + (argument.is_list() ? "...]" : "]") + "\n";
  const bool options = std::ranges::any_of(command.arguments(), [](const auto& a) { return !a.positional(); });
  return text + (options ? "[\\fIoption\\fR...]\n" : "");
}

struct Commands {
  std::string lines, sections;

  void add(const Command& command, const std::string& name) {
    if (command.hidden()) return;
    if (command.action()) {
      lines += std::string(lines.empty() ? "" : ".br\n") + synopsis(command, name);
      sections += ".SS " + plain(name) + "\n" + plain(command.summary()) + "\n";
      for (const Argument& argument : command.arguments())
        sections += entry(argument.name, argument.positional() ? "" : placeholder(argument), help_of(argument));
    }
    for (const auto& sub : command.commands()) add(*sub, name + " " + sub->name());
  }
};

}  // namespace

std::string manual_page(const CommandLine& line, const Manual& manual) {
  Commands commands;
  commands.add(line.root(), line.name());
  std::string summary = line.root().summary();
  if (const std::string prefix = line.name() + ": "; summary.starts_with(prefix)) summary.erase(0, prefix.size());
  std::string page = ".TH " + upper(line.name()) + " 1 \"\" \"" + line.name() + " " + line.version() + "\"\n" +
                     ".SH NAME\n" + line.name() + " \\- " + plain(summary) + "\n.SH SYNOPSIS\n" + commands.lines +
                     ".SH DESCRIPTION\n";
  for (std::size_t begin = 0; begin < manual.description.size();) {
    const std::size_t end = std::min(manual.description.find("\n\n", begin), manual.description.size());
    page += ".PP\n" + plain(manual.description.substr(begin, end - begin)) + "\n";
    begin = end + 2;
  }
  page += ".SH COMMANDS\n" + commands.sections;
  for (const Manual::Section& section : manual.sections) {
    page += ".SH " + plain(upper(section.title)) + "\n";
    for (const auto& [term, text] : section.entries) page += entry(term, "", text);
  }
  return page;
}

std::vector<std::pair<std::string, std::string>> manual_entries(const std::vector<OptionSpec>& specs) {
  std::vector<std::pair<std::string, std::string>> entries;
  for (const OptionSpec& spec : specs) {
    const std::string value = to_text(spec, spec.default_value);
    entries.emplace_back(spec.key, spec.summary + (value.empty() ? "" : " (default: " + value + ")"));
  }
  return entries;
}

}  // namespace base
