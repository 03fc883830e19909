// What `make exercise` prints: a line for each question, which has no answer yet, or is right, or
// gets the reply of judge.h; then how many of each. Never what a check compares with.

#define DOCTEST_CONFIG_IMPLEMENT
#include <doctest/doctest.h>

#include <iostream>
#include <sstream>
#include <string>
#include <string_view>

namespace {

constexpr std::size_t columns = 100;

/// Breaks a text at blanks, its further lines indented.
std::string wrapped(const std::string& text) {
  constexpr std::string_view further = "\n    ";
  std::string lines, word;
  std::size_t start = 0;  // of the last line
  for (std::istringstream words(text); words >> word; lines += word) {
    if (lines.size() - start + 1 + word.size() > columns) {
      start = lines.size() + 1;
      lines += further;
    } else if (!lines.empty()) {
      lines += " ";
    }
  }
  return lines;
}

/// The questions of one page, or of all.
class Answers : public doctest::IReporter {
 public:
  explicit Answers(const doctest::ContextOptions& options) : out_(*options.cout) {}

  void test_case_start(const doctest::TestCaseData& test) override {
    question_ = question_of(test);
    reply_.clear();
  }
  void test_case_end(const doctest::CurrentTestCaseStats& stats) override {
    const bool is_right = stats.failure_flags == 0;
    ++(is_right ? right_ : wrong_);
    out_ << wrapped(question_ + ": " + (is_right ? "right" : reply_)) << "\n";
  }
  void test_case_skipped(const doctest::TestCaseData& test) override {
    ++unanswered_;
    out_ << question_of(test) << ": unanswered\n";
  }
  void log_assert(const doctest::AssertData& failed) override {
    if (!failed.m_failed || !reply_.empty()) return;
    std::ostringstream said;
    for (int i = 0; i < get_num_active_contexts(); ++i) {
      get_active_contexts()[i]->stringify(&said);
    }
    reply_ = said.str();
    if (reply_.empty()) {
      reply_ = std::string(failed.m_file) + ":" + std::to_string(failed.m_line) + " does not hold";
    }
  }
  void test_case_exception(const doctest::TestCaseException& stopped) override {
    if (reply_.empty()) reply_ = std::string("stops: ") + stopped.error_string.c_str();
  }
  void test_run_end(const doctest::TestRunStats&) override {
    out_ << right_ << " right, " << wrong_ << " wrong, " << unanswered_ << " unanswered\n";
  }

  void report_query(const doctest::QueryData&) override {}
  void test_run_start() override {}
  void test_case_reenter(const doctest::TestCaseData&) override {}
  void subcase_start(const doctest::SubcaseSignature&) override {}
  void subcase_end() override {}
  void log_message(const doctest::MessageData&) override {}

 private:
  /// A test is named "page, kind: what is right".
  static std::string question_of(const doctest::TestCaseData& test) {
    const std::string name = test.m_name;
    return name.substr(0, name.find(':'));
  }

  std::ostream& out_;
  std::string question_, reply_;
  int right_ = 0, wrong_ = 0, unanswered_ = 0;
};

}  // namespace

REGISTER_REPORTER("answers", 1, Answers);

int main(int argc, char** argv) {
  doctest::Context context;
  context.setOption("reporters", "answers");
  context.setOption("no-intro", true);
  context.setOption("no-version", true);
  context.applyCommandLine(argc, argv);
  return context.run();
}
