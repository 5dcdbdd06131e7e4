// The control experiment of the jitter laboratory: the same paced loop as in Java, without a JVM.
// Its lateness is due to the machine alone.
//
//   palpate-control --wait sleep|absolute|hybrid|spin --frames N --warm-up N --period NANOS
//                   --priority 0|1..99 --cpu N|-1 --lock 0|1
//                   --rest MICROS --rest-period MICROS --out FILE
// The kernel takes the processor from a real-time thread for the rest in each rest period.
// FILE receives one record for each frame: six 64-bit integers in the machine's byte order.
//
//   due      deadline of the frame, ns of CLOCK_MONOTONIC
//   start    start of its work
//   end      end of its work
//   delayed  total time in which this thread was ready but did not run, ns (the kernel's schedstat)
//   preempted  total number of preemptions
//   faults   total number of pages read from a disk
// Standard output receives a line for each request to the kernel, as in "class granted fifo 40".
#include <fcntl.h>
#include <sched.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <map>
#include <string>
#include <vector>

namespace {

constexpr int64_t kNanosPerSecond = 1000000000;
constexpr int64_t kLeastWindowNanos = 20000;
constexpr int64_t kMostWindowNanos = 400000;
constexpr int kWindowSleeps = 200;

// As in RestBudget in Java: the sleep over the kernel's rest, the least debt that is worth a sleep,
// and the debt that is paid even if a frame is late then.
constexpr double kRestMargin = 1.3;
constexpr double kLeastOwedNanos = 50000;
constexpr double kMostWaitingNanos = 2000000;

struct Record {
  int64_t due;
  int64_t start;
  int64_t end;
  int64_t delayed;
  int64_t preempted;
  int64_t faults;
};

int64_t nanos() {
  timespec time{};
  clock_gettime(CLOCK_MONOTONIC, &time);
  return time.tv_sec * kNanosPerSecond + time.tv_nsec;
}

timespec toTimespec(int64_t value) {
  return {static_cast<time_t>(value / kNanosPerSecond), static_cast<long>(value % kNanosPerSecond)};
}

void sleepUntil(int64_t moment) {
  timespec time = toTimespec(moment);
  clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &time, nullptr);
}

void sleepFor(int64_t duration) {
  if (duration > 0) {
    timespec time = toTimespec(duration);
    nanosleep(&time, nullptr);
  }
}

void spinUntil(int64_t moment) {
  while (nanos() < moment) {
  }
}

/** Returns a quarter more than the 99th percentile of the lateness of this thread's wake-ups. */
int64_t measureWindow(int64_t period) {
  std::vector<int64_t> late;
  for (int i = 0; i < kWindowSleeps; i++) {
    int64_t due = nanos() + period * 9 / 10;
    sleepUntil(due);
    late.push_back(nanos() - due);
  }
  std::sort(late.begin(), late.end());
  int64_t covered = late[kWindowSleeps * 99 / 100];
  return std::clamp(covered + covered / 4, kLeastWindowNanos, kMostWindowNanos);
}

/** The sleep that a real-time thread owes the kernel, by the rule of RestBudget in Java. */
class RestBudget {
 public:
  RestBudget(int64_t restMicros, int64_t periodMicros)
      : fraction_(std::min(1.0, kRestMargin * restMicros / periodMicros)),
        mostOwed_(fraction_ * periodMicros * 1000) {}

  /** Returns when a sleep is to end that begins now; the present time if none is due. */
  int64_t wake(int64_t now, int64_t due) {
    if (last_ != 0) {
      owed_ = std::min(mostOwed_, owed_ + fraction_ * (now - last_));
    }
    last_ = now;
    int64_t wake = now + static_cast<int64_t>(std::ceil(owed_));
    bool mayBeLate = owed_ >= kMostWaitingNanos;
    return owed_ >= kLeastOwedNanos && (wake <= due || mayBeLate) ? wake : now;
  }

  void slept(int64_t now) {
    owed_ = std::max(0.0, owed_ - (now - last_));
    last_ = now;
  }

 private:
  double fraction_;
  double mostOwed_;
  double owed_ = 0;
  int64_t last_ = 0;
};

class Pacer {
 public:
  Pacer(const std::string& wait, int64_t period, RestBudget rest) : wait_(wait), rest_(rest) {
    if (wait_ == "hybrid") {
      windowNanos_ = measureWindow(period);
    }
  }

  int64_t windowNanos() const { return windowNanos_; }

  void awaitMoment(int64_t due) {
    if (wait_ == "spin") {
      spinUntil(due);
    } else if (wait_ == "sleep") {
      sleepFor(due - nanos());
    } else if (wait_ == "absolute") {
      sleepUntil(due);
    } else {
      sleepThenSpin(due);
    }
  }

 private:
  void sleepThenSpin(int64_t due) {
    int64_t now = nanos();
    int64_t wake = std::max(due - windowNanos_, rest_.wake(now, due));
    if (now < wake) {
      sleepUntil(wake);
      rest_.slept(nanos());
    }
    spinUntil(due);
  }

  std::string wait_;
  RestBudget rest_;
  int64_t windowNanos_ = 0;
};

/** The kernel's own counters of the calling thread. */
class Counters {
 public:
  Counters() : schedstat_(open("/proc/thread-self/schedstat", O_RDONLY | O_CLOEXEC)) {}
  ~Counters() {
    if (schedstat_ >= 0) {
      close(schedstat_);
    }
  }
  Counters(const Counters&) = delete;
  Counters& operator=(const Counters&) = delete;

  void read(Record& record) const {
    char text[96];
    ssize_t length = schedstat_ < 0 ? -1 : pread(schedstat_, text, sizeof text - 1, 0);
    if (length > 0) {
      text[length] = 0;
      char* rest = nullptr;
      std::strtoll(text, &rest, 10);
      record.delayed = std::strtoll(rest, nullptr, 10);
    }
    rusage usage{};
    getrusage(RUSAGE_THREAD, &usage);
    record.preempted = usage.ru_nivcsw;
    record.faults = usage.ru_majflt;
  }

 private:
  int schedstat_;
};

void tell(const char* wish, bool granted, const std::string& detail) {
  std::printf("%s %s %s\n", wish, granted ? "granted" : "refused", detail.c_str());
}

void tellAnswer(const char* wish, int result, const std::string& what) {
  tell(wish, result == 0, result == 0 ? what : std::strerror(errno));
}

using Options = std::map<std::string, std::string>;

int64_t number(const Options& options, const char* name, int64_t otherwise) {
  auto found = options.find(name);
  return found == options.end() ? otherwise : std::strtoll(found->second.c_str(), nullptr, 10);
}

void askKernel(const Options& options) {
  if (number(options, "--lock", 0) != 0) {
    tellAnswer("memory_lock", mlockall(MCL_CURRENT | MCL_FUTURE), "now and later pages");
  }
  tellAnswer("timer_slack", prctl(PR_SET_TIMERSLACK, 1), "1 ns");
  int cpu = static_cast<int>(number(options, "--cpu", -1));
  if (cpu >= 0) {
    cpu_set_t only;
    CPU_ZERO(&only);
    CPU_SET(cpu, &only);
    tellAnswer("affinity", sched_setaffinity(0, sizeof only, &only), "cpu " + std::to_string(cpu));
  }
  int priority = static_cast<int>(number(options, "--priority", 0));
  if (priority > 0) {
    sched_param param{};
    param.sched_priority = priority;
    tellAnswer("class", sched_setscheduler(0, SCHED_FIFO, &param),
               "fifo " + std::to_string(priority));
  }
}

/**
 * Returns the next deadline: the first one of a fixed grid that is at least half a period away, as
 * in the haptic loop.
 */
int64_t nextDue(int64_t due, int64_t began, int64_t period) {
  int64_t late = began - due;
  int64_t missed = late > period / 2 ? (late + period / 2) / period : 0;
  return due + (missed + 1) * period;
}

void run(Pacer& pacer, int64_t warmUp, int64_t period, std::vector<Record>& records) {
  Counters counters;
  int64_t due = nanos() + 5 * period;
  int64_t frames = static_cast<int64_t>(records.size());
  for (int64_t i = -warmUp; i < frames; i++) {
    pacer.awaitMoment(due);
    Record record{due, nanos(), 0, 0, 0, 0};
    record.end = nanos();
    counters.read(record);
    if (i >= 0) {
      records[i] = record;
    }
    due = nextDue(due, record.start, period);
  }
}

bool write(const std::string& file, const std::vector<Record>& records) {
  std::FILE* out = std::fopen(file.c_str(), "wb");
  if (out == nullptr) {
    return false;
  }
  size_t written = std::fwrite(records.data(), sizeof(Record), records.size(), out);
  return std::fclose(out) == 0 && written == records.size();
}

bool parse(int count, char** words, Options& options) {
  for (int i = 1; i + 1 < count; i += 2) {
    options[words[i]] = words[i + 1];
  }
  const std::string wait = options["--wait"];
  bool known = wait == "sleep" || wait == "absolute" || wait == "hybrid" || wait == "spin";
  return count % 2 == 1 && known && options.count("--out") == 1;
}

}  // namespace

int main(int count, char** words) {
  Options options;
  if (!parse(count, words, options)) {
    std::fprintf(
        stderr,
        "palpate-control: wrong use: arguments: --wait sleep|absolute|hybrid|spin --frames "
        "N --warm-up N --period NANOS --priority P --cpu N --lock 0|1 --rest MICROS --rest-period "
        "MICROS --out FILE\n");
    return 2;
  }
  std::vector<Record> records(number(options, "--frames", 1000), Record{});
  askKernel(options);
  int64_t period = number(options, "--period", 1000000);
  RestBudget rest(number(options, "--rest", 0), number(options, "--rest-period", 1000000));
  Pacer pacer(options["--wait"], period, rest);
  std::printf("spin_window_nanos %lld\n", static_cast<long long>(pacer.windowNanos()));
  run(pacer, number(options, "--warm-up", 1000), period, records);
  if (!write(options["--out"], records)) {
    std::fprintf(stderr, "palpate-control: cannot write: %s: %s\n", options["--out"].c_str(),
                 std::strerror(errno));
    return 1;
  }
  return 0;
}
