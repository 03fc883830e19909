// Numbers in reports: bounds stay bounds.

#include "app/report_lines.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "app/report.h"
#include "tests/support/ball_sets.h"
#include "tests/support/seeds.h"

using namespace morskin;

TEST_CASE("a bound is rounded to no less than it was, by less than one of its last digit") {
  std::size_t raised = 0;
  support::for_seeds(20'000, [&](unsigned seed) {
    support::Random random(seed);
    const double number = std::pow(10, random.between(-12, 6));
    const auto digits = static_cast<int>(1 + random.below(8));
    CAPTURE(number);
    CAPTURE(digits);
    const double bound = app::rounded_bound(number, digits);
    CHECK(bound >= number);
    CHECK(bound < number + 1.000001 * std::pow(10, std::floor(std::log10(number)) - digits + 1));
    CHECK(bound == app::rounded(bound, digits));  // it has no more digits
    CHECK(app::brief_bound(number, digits) == app::brief(bound, digits));
    CHECK(app::rounded_bound(bound, digits) == bound);
    raised += bound > app::rounded(number, digits);
  });
  CHECK(raised > 5000);  // where the nearest is below
  for (const int digits : {1, 4, 6}) CHECK(app::rounded_bound(0, digits) == 0);
  CHECK(app::brief_bound(0.99991, 3) == "1");
  CHECK(app::brief_bound(1.0001, 3) == "1.01");
}

TEST_CASE("rounded bounds lie on their sides of a number, a unit of the last digit apart") {
  support::for_seeds(10'000, [&](unsigned seed) {
    support::Random random(seed);
    double number = std::pow(10, random.between(-12, 12));
    // Every second one beside what rounding to the nearest gives.
    if (seed % 2 == 0) number = std::nextafter(app::rounded(number), seed % 4 == 0 ? 0 : INFINITY);
    CAPTURE(number);
    const double low = app::rounded_lower_bound(number), high = app::rounded_bound(number);
    CHECK(low <= number);
    CHECK(number <= high);
    CHECK(high - low < 1.001e-5 * number);
    CHECK(app::brief_lower_bound(number, 6) == app::brief(low, 6));
  });
  CHECK(app::rounded_lower_bound(0) == 0);
  CHECK(app::brief_lower_bound(0.99999, 3) == "0.999");
}

TEST_CASE("angles just beyond a bound do not look as if they kept it") {
  CHECK(app::angles_text(30, 105) == "30 to 105 degrees");
  CHECK(app::angles_text(29.9996, 105.0001) == "29.99 to 105.1 degrees");
}

TEST_CASE("a certificate's distances are no shorter in JSON than they were proved") {
  support::for_seeds(1000, [&](unsigned seed) {
    support::Random random(seed);
    certify::Certificate certificate;
    certificate.max_distance_to_skin = std::pow(10, random.between(-9, 1));
    certificate.max_relative_distance_to_skin = std::pow(10, random.between(-9, 0));
    const auto json = app::certificate_json(certificate);
    CHECK(json.at("max_distance_to_skin") >= certificate.max_distance_to_skin);
    CHECK(json.at("max_relative_distance_to_skin") >= certificate.max_relative_distance_to_skin);
  });
}
