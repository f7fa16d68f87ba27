/// The unit tests as `verify/mutants` asks them: up to the first that fails.

#include <gtest/gtest.h>

#include <cstdio>
#include <map>

#include "verify/mutation/units.hpp"

namespace {

class Watch : public testing::EmptyTestEventListener {
 public:
  explicit Watch(const std::vector<goishi::mutant::Unit>& units) {
    for (const goishi::mutant::Unit& unit : units) {
      seconds_[unit.name] = unit.seconds;
    }
  }

 private:
  void OnTestStart(const testing::TestInfo& test) override {
    const std::string name = std::string(test.test_suite_name()) + "." + test.name();
    goishi::mutant::begin({seconds_[name], name});
  }
  void OnTestEnd(const testing::TestInfo& test) override {
    if (test.result()->Failed()) {
      std::_Exit(1);
    }
  }

  std::map<std::string, double> seconds_;
};

}  // namespace

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  testing::UnitTest& all = *testing::UnitTest::GetInstance();
  if (argc == 2 && std::string(argv[1]) == "--list") {
    for (int i = 0; i < all.total_test_suite_count(); ++i) {
      const testing::TestSuite& suite = *all.GetTestSuite(i);
      for (int j = 0; j < suite.total_test_count(); ++j) {
        std::printf("%s.%s\ttest\n", suite.name(), suite.GetTestInfo(j)->name());
      }
    }
    return 0;
  }
  const std::vector<goishi::mutant::Unit> units = goishi::mutant::units_of(argc, argv);
  std::string filter;
  for (const goishi::mutant::Unit& unit : units) {
    filter += unit.name + ":";
  }
  GTEST_FLAG_SET(filter, filter);
  delete all.listeners().Release(all.listeners().default_result_printer());
  all.listeners().Append(new Watch(units));
  return RUN_ALL_TESTS();
}
