#include <fmt/format.h>

#include <pleura/x3d/browser/commands/number_in.h>

namespace pleura {

CLI::Validator numberIn(double least, double most) {
  const auto expected = fmt::format("number in [{:g} - {:g}]", least, most);
  const auto check = [=](const std::string& text) {
    double number = 0;
    const bool isInside = CLI::detail::lexical_cast(text, number) && number >= least && number <= most;
    return isInside ? std::string() : fmt::format("{} is no {}", text, expected);
  };
  return CLI::Validator(check, expected);
}

}  // namespace pleura
