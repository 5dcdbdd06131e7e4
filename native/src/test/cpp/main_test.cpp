#include "bench.h"
#include "check.h"

int main(int count, char** arguments) {
  bench::advanceMillis(0);  // from now on tests set the time
  return check::runAll(count, arguments);
}
