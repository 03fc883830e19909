#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace morskin::app {

/// A line of a report: two spaces, the label in a column, the text.
std::string line(std::string_view label, const std::string& text);
/// An integer with commas between thousands.
std::string grouped(long long number);
std::string grouped(std::size_t number);
/// "1 triangle", "2 triangles".
std::string counted(std::size_t count, const std::string& one, const std::string& more);
/// At most `digits` significant digits.
std::string brief(double number, int digits = 4);
/// The same of a bound: not below the number. @pre number >= 0
std::string brief_bound(double number, int digits);
/// The same of a lower bound: not above the number. @pre number >= 0
std::string brief_lower_bound(double number, int digits);
/// The angles of triangles, "30.02 to 104.9 degrees", rounded outwards.
std::string angles_text(double min_deg, double max_deg);
/// The double nearest to `number` with so many significant digits, for JSON that people read.
double rounded(double number, int digits = 6);
/// The same of a bound: not below the number. @pre number >= 0
double rounded_bound(double number, int digits = 6);
/// The same of a lower bound: not above the number. @pre number >= 0
double rounded_lower_bound(double number, int digits = 6);

}  // namespace morskin::app
