#include "Base/console/argument_values.h"

#include <algorithm>
#include <limits>

#include "Base/error.h"
#include "Base/names/nearest_name.h"

namespace base {
namespace {

template <class... Cases>
struct Overloaded : Cases... {
  using Cases::operator()...;
};
template <class... Cases>
Overloaded(Cases...) -> Overloaded<Cases...>;

// "--sizes: 'x' is not a whole number" for a word that cannot be read as a T.
template <class T>
T value_of(const Argument& argument, const std::string& word) {
  try {
    return std::get<T>(parse_option(word, OptionValue(T())));
  } catch (const InputError& error) {
    throw InputError(argument.name + ": " + error.what());
  }
}

template <>
int value_of<int>(const Argument& argument, const std::string& word) {
  const long value = value_of<long>(argument, word);
  if (value < std::numeric_limits<int>::min() || value > std::numeric_limits<int>::max())
    throw InputError(argument.name + ": " + word + " is too large");
  return static_cast<int>(value);
}

template <>
std::string value_of<std::string>(const Argument& argument, const std::string& word) {
  if (argument.names_only && std::ranges::find(argument.names, word) == argument.names.end()) {
    const std::vector<std::string_view> known(argument.names.begin(), argument.names.end());
    throw InputError(argument.name + ": " + unknown_name_message("word", word, known));
  }
  return word;
}

std::vector<std::string> split_at_commas(std::span<const std::string> words) {
  std::vector<std::string> parts;
  for (const std::string& word : words)
    for (std::size_t begin = 0; begin <= word.size();) {
      const std::size_t end = std::min(word.find(',', begin), word.size());
      parts.push_back(word.substr(begin, end - begin));
      begin = end + 1;
    }
  return parts;
}

template <class T>
void assign_list(const Argument& argument, std::span<const std::string> words, std::vector<T>& list) {
  list.clear();
  const bool commas = argument.list == Argument::List::commas;
  for (const std::string& word : commas ? split_at_commas(words) : std::vector(words.begin(), words.end()))
    list.push_back(value_of<T>(argument, word));
}

template <class T>
std::string list_text(const std::vector<T>& list) {
  std::string text;
  for (const T& value : list) text += (text.empty() ? "" : ",") + to_text(OptionValue(value));
  return text;
}

}  // namespace

void assign(const Argument& argument, std::span<const std::string> words) {
  if (!argument.is_list() && words.size() > 1)
    throw InputError(argument.name + " is given more than once: " + words[0] + ", " + words[1]);
  std::visit(Overloaded{[](bool* flag) { *flag = true; },  //
                        [](const std::function<void()>& call) { call(); },
                        [&]<class T>(std::optional<T>* value) { *value = value_of<T>(argument, words.front()); },
                        [&]<class T>(std::vector<T>* list) { assign_list(argument, words, *list); },
                        [&]<class T>(T* value) { *value = value_of<T>(argument, words.front()); }},
             argument.target);
}

std::string default_text(const Argument& argument) {
  return std::visit(Overloaded{[](bool*) { return std::string(); },  //
                               [](const std::function<void()>&) { return std::string(); },
                               [](int* value) { return to_text(OptionValue(static_cast<long>(*value))); },
                               []<class T>(std::optional<T>* value) {
                                 return *value ? to_text(OptionValue(**value)) : std::string();
                               },
                               []<class T>(std::vector<T>* list) { return list_text(*list); },
                               []<class T>(T* value) { return to_text(OptionValue(*value)); }},
                    argument.target);
}

std::string placeholder(const Argument& argument) {
  if (argument.flag()) return "";
  if (!argument.assigns.empty()) return "KEY=VALUE";
  std::string one = std::visit(Overloaded{[](const std::function<void()>&) { return ""; },
                                          []<class T>(const T&) {
                                            using Held = std::remove_pointer_t<T>;
                                            if constexpr (std::is_same_v<Held, double> ||
                                                          std::is_same_v<Held, std::optional<double>> ||
                                                          std::is_same_v<Held, std::vector<double>>)
                                              return "X";
                                            else if constexpr (std::is_same_v<Held, std::string> ||
                                                               std::is_same_v<Held, std::vector<std::string>>)
                                              return "NAME";
                                            else
                                              return "N";
                                          }},
                               argument.target);
  if (argument.offers == Argument::Offers::files) one = "FILE";
  if (argument.offers == Argument::Offers::folders) one = "DIR";
  if (!argument.is_list()) return one;
  if (argument.list == Argument::List::commas) return one + "," + one + ",...";
  if (argument.count == 0) return one + "...";
  std::string all = one;
  for (int i = 1; i < argument.count; ++i) all += " " + one;
  return all;
}

}  // namespace base
