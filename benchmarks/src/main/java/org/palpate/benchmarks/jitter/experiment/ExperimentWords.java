package org.palpate.benchmarks.jitter.experiment;

import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.stream.Collectors;

/** Names experiments in words, for plots. */
public final class ExperimentWords {
  private static final Map<String, String> WORDS =
      Map.ofEntries(
          Map.entry("g1", "G1"),
          Map.entry("zgc", "ZGC"),
          Map.entry("genzgc", "generational ZGC"),
          Map.entry("park", "parkNanos"),
          Map.entry("sleep", "Thread.sleep"),
          Map.entry("absolute", "absolute sleep"),
          Map.entry("hybrid", "sleep, then spin"),
          Map.entry("normal", "normal priority"),
          Map.entry("fifo", "SCHED_FIFO"),
          Map.entry("fifovm", "SCHED_FIFO, VM thread too"),
          Map.entry("empty", "empty frame"),
          Map.entry("frame", "haptic frame"),
          Map.entry("view", "haptic frame and view"),
          Map.entry("none", "quiet process"),
          Map.entry("alloc", "beside an allocating thread"),
          Map.entry("burn", "beside a busy thread"),
          Map.entry("default", "default compilers"),
          Map.entry("c1", "C1 alone"),
          Map.entry("cds", "class archive"),
          Map.entry("aot", "AOT cache"));

  private ExperimentWords() {}

  /** Returns all settings of an experiment in words. */
  public static String all(Experiment experiment) {
    return String.join(", ", settings(experiment).values());
  }

  /**
   * Returns the words for each experiment, by its key: the runtime, and the settings in which the
   * experiments differ. Equal ones are numbered.
   */
  public static Map<String, String> differences(List<Experiment> experiments) {
    Map<String, Set<String>> values = new LinkedHashMap<>();
    for (Experiment experiment : experiments) {
      settings(experiment)
          .forEach(
              (setting, value) ->
                  values.computeIfAbsent(setting, any -> new LinkedHashSet<>()).add(value));
    }
    Map<String, String> names = new LinkedHashMap<>();
    for (Experiment experiment : experiments) {
      String name =
          settings(experiment).entrySet().stream()
              .filter(s -> s.getKey().equals("runtime") || values.get(s.getKey()).size() > 1)
              .map(Map.Entry::getValue)
              .collect(Collectors.joining(", "));
      names.put(experiment.key(), numbered(name, names));
    }
    return names;
  }

  private static String numbered(String name, Map<String, String> taken) {
    String numbered = name;
    for (int n = 2; taken.containsValue(numbered); n++) {
      numbered = name + " (" + n + ")";
    }
    return numbered;
  }

  /** Returns the settings of an experiment; the loop in C++ has fewer. */
  private static Map<String, String> settings(Experiment experiment) {
    Map<String, String> settings = new LinkedHashMap<>();
    boolean control = experiment.isControl();
    settings.put(
        "runtime",
        control ? "C++" : experiment.jdk().label().toUpperCase(Locale.ROOT).replace("JDK", "JDK "));
    if (!control) {
      settings.put("collector", words(experiment.collector().label()));
    }
    settings.put("wait", words(Experiment.lower(experiment.waiting())));
    settings.put("scheduling", words(experiment.scheduling().label()));
    if (!control) {
      settings.put("workload", words(experiment.workload().label()));
      settings.put("load", words(experiment.load().label()));
      settings.put("jit", words(experiment.jit().label()));
      settings.put("heap", JvmCommand.heapMb(experiment) + " MB");
    }
    settings.put("rate", experiment.rateHz() + " Hz");
    settings.put("seconds", experiment.seconds() + " s");
    return settings;
  }

  private static String words(String label) {
    return WORDS.getOrDefault(label, label);
  }
}
