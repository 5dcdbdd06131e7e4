#ifndef PALPATE_CHECK_H
#define PALPATE_CHECK_H

#include <cstdio>
#include <cstdlib>
#include <sstream>
#include <string>
#include <vector>

namespace check {

/** A test: a sentence, and the function that shows that it holds. */
struct Test {
  const char* sentence;
  void (*run)();
};

inline std::vector<Test>& tests() {
  static std::vector<Test> all;
  return all;
}

inline int& failures() {
  static int count = 0;
  return count;
}

constexpr int kMostShown = 100;

struct Registration {
  Registration(const char* sentence, void (*run)()) { tests().push_back({sentence, run}); }
};

inline void report(bool holds, const char* file, int line, const std::string& what) {
  if (!holds && ++failures() <= kMostShown) {
    std::fprintf(stderr, "%s:%d: %s\n", file, line, what.c_str());
  }
}

template <typename T>
std::string text(const T& value) {
  std::ostringstream out;
  out.precision(17);
  out << value;
  return out.str();
}

template <typename E, typename A>
void equal(const E& expected, const A& actual, const char* file, int line, const char* what) {
  const bool holds = expected == actual;
  report(holds, file, line,
         holds ? "" : std::string(what) + " is " + text(actual) + ", not " + text(expected));
}

inline void near(double expected, double actual, double tolerance, const char* file, int line,
                 const char* what) {
  const bool holds = actual - expected <= tolerance && expected - actual <= tolerance;
  report(holds, file, line,
         holds ? "" : std::string(what) + " is " + text(actual) + ", not " + text(expected));
}

/** Runs the tests whose sentence contains the first argument; all tests without an argument. */
inline int runAll(int count, char** arguments) {
  const std::string wanted = count > 1 ? arguments[1] : "";
  int ran = 0;
  for (const Test& test : tests()) {
    if (std::string(test.sentence).find(wanted) == std::string::npos) {
      continue;
    }
    const int before = failures();
    test.run();
    ran++;
    if (failures() > before) {
      std::fprintf(stderr, "FAILED: %s\n", test.sentence);
    }
  }
  std::printf("%d tests, %d checks failed\n", ran, failures());
  return failures() == 0 && ran > 0 ? 0 : 1;
}

}  // namespace check

#define CHECK_JOIN2(a, b) a##b
#define CHECK_JOIN(a, b) CHECK_JOIN2(a, b)
#define TEST(sentence)                                                                             \
  static void CHECK_JOIN(test, __LINE__)();                                                        \
  static const check::Registration CHECK_JOIN(registration, __LINE__)(sentence,                    \
                                                                      CHECK_JOIN(test, __LINE__)); \
  static void CHECK_JOIN(test, __LINE__)()
#define CHECK(condition) check::report((condition), __FILE__, __LINE__, #condition)
#define CHECK_THAT(condition, why) \
  check::report((condition), __FILE__, __LINE__, std::string(#condition ": ") + (why))
#define CHECK_EQUAL(expected, actual) \
  check::equal((expected), (actual), __FILE__, __LINE__, #actual)
#define CHECK_NEAR(expected, actual, tolerance) \
  check::near((expected), (actual), (tolerance), __FILE__, __LINE__, #actual)

#endif
