#include "bench.h"
#include "check.h"

int main(int count, char** arguments) {
  bench::advanceMillis(0);  // from here on time is the tests'
  return check::runAll(count, arguments);
}
