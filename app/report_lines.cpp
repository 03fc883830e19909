#include "app/report_lines.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "geometry/files/text_lines.h"

namespace morskin::app {

std::string line(std::string_view label, const std::string& text) {
  std::string result = "  " + std::string(label);
  result.resize(std::max<std::size_t>(result.size() + 1, 14), ' ');
  return result + text + "\n";
}

std::string grouped(long long number) {
  const std::string digits = std::to_string(number);
  std::string text;
  for (std::size_t i = 0; i < digits.size(); ++i) {
    const bool starts_group = (digits.size() - i) % 3 == 0;
    if (starts_group && i > 0 && digits[i - 1] != '-') text.push_back(',');
    text.push_back(digits[i]);
  }
  return text;
}

std::string grouped(std::size_t number) { return grouped(static_cast<long long>(number)); }

std::string counted(std::size_t count, const std::string& one, const std::string& more) {
  return grouped(count) + " " + (count == 1 ? one : more);
}

std::string brief(double number, int digits) { return geometry::in_digits(number, digits); }

std::string brief_bound(double number, int digits) {
  return brief(rounded_bound(number, digits), digits);
}

std::string brief_lower_bound(double number, int digits) {
  return brief(rounded_lower_bound(number, digits), digits);
}

std::string angles_text(double min_deg, double max_deg) {
  return brief_lower_bound(min_deg, 4) + " to " + brief_bound(max_deg, 4) + " degrees";
}

double rounded(double number, int digits) {
  return std::strtod(brief(number, digits).c_str(), nullptr);
}

namespace {

/// By how much such numbers differ at least.
double step_of(double number, int digits) {
  return std::pow(10, std::floor(std::log10(number)) - digits + 1);
}

}  // namespace

double rounded_bound(double number, int digits) {
  const double nearest = rounded(number, digits);
  return nearest < number ? rounded(nearest + step_of(number, digits), digits) : nearest;
}

double rounded_lower_bound(double number, int digits) {
  const double nearest = rounded(number, digits);
  return nearest > number ? rounded(nearest - step_of(number, digits), digits) : nearest;
}

}  // namespace morskin::app
