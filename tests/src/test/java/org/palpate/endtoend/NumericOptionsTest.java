package org.palpate.endtoend;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.math.BigDecimal;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.ServiceLoader;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.palpate.app.CommandProvider;
import org.palpate.app.command.DevicesCommand;
import org.palpate.app.command.InfoCommand;
import org.palpate.app.command.RenderCommand;
import org.palpate.app.command.ReplayCommand;
import org.palpate.app.command.TouchCommand;
import org.palpate.fracture.fit.FaceFit;
import org.palpate.io.file.NumberText;
import picocli.CommandLine;
import picocli.CommandLine.Model.OptionSpec;

/** Gives every numeric option of every command numbers outside its range. */
class NumericOptionsTest {
  private static final String REPLAY = "replay --phantom sphere:16 --trajectory t.csv";

  /**
   * An option and its range.
   *
   * @param with the command with all other options that it needs
   * @param valuePrefix what stands before the number
   */
  private record Ranged(
      String with, String option, String valuePrefix, double low, double high, boolean whole) {
    static Ranged real(String with, String option, double low, double high) {
      return new Ranged(with, option, "", low, high, false);
    }

    static Ranged whole(String with, String option, double low, double high) {
      return new Ranged(with, option, "", low, high, true);
    }

    String name() {
      return with.substring(0, with.indexOf(' ')) + " " + option;
    }
  }

  private static final List<Ranged> OPTIONS =
      List.of(
          Ranged.real("touch --headless", "--rate", 10, 100_000),
          Ranged.real("touch --headless", "--seconds", 0.001, 1e8),
          Ranged.real("touch --headless", "--stiffness", 1e-6, 1e6),
          Ranged.real("touch --headless", "--friction", 0, 100),
          Ranged.real("touch --headless", "--max-step", 1e-6, 1e6),
          Ranged.real("touch --headless", "--max-force", 1e-6, 1e6),
          Ranged.real("touch --headless", "--carve", 1e-6, 1e6),
          Ranged.real("touch --headless", "--mass", 1e-6, 1e6),
          Ranged.real("touch --headless", "--guide-stiffness", 1e-6, 1e6),
          Ranged.real("touch --headless", "--guide-force", 1e-6, 1e6),
          Ranged.real("touch --headless", "--guide-range", 1e-6, 1e6),
          Ranged.real("touch --headless --elastic skull=young:1e4", "--lattice", 1e-6, 1e6),
          Ranged.real("touch --headless --elastic skull=young:1e4", "--contact-radius", 1e-6, 1e6),
          Ranged.real("touch --headless --tool sphere:2", "--rotational-stiffness", 1e-6, 1e6),
          Ranged.real(REPLAY, "--stiffness", 1e-6, 1e6),
          Ranged.real(REPLAY, "--friction", 0, 100),
          Ranged.real(REPLAY, "--max-step", 1e-6, 1e6),
          Ranged.real(REPLAY, "--max-force", 1e-6, 1e6),
          Ranged.real(REPLAY, "--carve", 1e-6, 1e6),
          Ranged.real(REPLAY, "--mass", 1e-6, 1e6),
          Ranged.real(REPLAY, "--guide-stiffness", 1e-6, 1e6),
          Ranged.real(REPLAY, "--guide-force", 1e-6, 1e6),
          Ranged.real(REPLAY, "--guide-range", 1e-6, 1e6),
          Ranged.real(REPLAY + " --elastic sphere=young:1e4", "--lattice", 1e-6, 1e6),
          Ranged.real(REPLAY + " --elastic sphere=young:1e4", "--contact-radius", 1e-6, 1e6),
          Ranged.real(REPLAY + " --tool sphere:2", "--rotational-stiffness", 1e-6, 1e6),
          Ranged.whole(REPLAY, "--repeat", 3, 1_000_000),
          Ranged.whole(REPLAY + " --tool sphere:2", "--legs-every", 1, Integer.MAX_VALUE),
          Ranged.real("render --out x.png --trajectory t.csv", "--stiffness", 1e-6, 1e6),
          Ranged.real("render --out x.png --trajectory t.csv", "--friction", 0, 100),
          Ranged.real("render --out x.png --trajectory t.csv", "--max-step", 1e-6, 1e6),
          Ranged.real("render --out x.png --trajectory t.csv", "--max-force", 1e-6, 1e6),
          Ranged.real("render --out x.png --trajectory t.csv", "--carve", 1e-6, 1e6),
          Ranged.real("render --out x.png --trajectory t.csv", "--mass", 1e-6, 1e6),
          Ranged.real(
              "render --out x.png --trajectory t.csv --tool sphere:2",
              "--rotational-stiffness",
              1e-6,
              1e6),
          Ranged.real(
              "render --out x.png --trajectory t.csv --elastic skull=young:1e4",
              "--lattice",
              1e-6,
              1e6),
          Ranged.real(
              "render --out x.png --trajectory t.csv --elastic skull=young:1e4",
              "--contact-radius",
              1e-6,
              1e6),
          Ranged.real("render --out x.png", "--zoom", 0.01, 1000),
          Ranged.whole("render --out x.gif --poses t.poses.csv", "--pictures", 2, 1000),
          Ranged.real("info --phantom fracture", "--fit", 0, FaceFit.MOST_GAP_MM),
          new Ranged("render --out x.png", "--opacity", "bone=", 0, 1, false),
          Ranged.real("devices --watch hid", "--seconds", 0.001, 1e8),
          Ranged.whole("jitter --list --out jitter", "--seconds", 1, 86_400),
          Ranged.real("jitter --list --out jitter", "--minutes", 0, 1_000_000),
          Ranged.whole("jitter --list --out jitter", "--heap", 128, 65_536),
          Ranged.whole("bench --stress --out bench", "--frames", 1, 1e12));

  /** Numeric options that another test holds, or that take every number of their type. */
  private static final Set<String> OTHERS =
      Set.of(
          "replay --points", // ToolRequestTest
          "touch --points",
          "render --points",
          "bench --seed", // every long is a seed
          "touch --time",
          "replay --time",
          "info --time",
          "render --time",
          "jitter --time"); // depends on the file: ReadingOptionsTest

  static Stream<Ranged> options() {
    return OPTIONS.stream();
  }

  @ParameterizedTest
  @MethodSource("options")
  void aNumberOutOfRangeIsRefusedWithTheRange(Ranged option) {
    for (String number : outside(option)) {
      List<String> arguments = new ArrayList<>(List.of(option.with().split(" ")));
      arguments.add(option.option());
      arguments.add(option.valuePrefix() + number);
      String line = CommandRun.of(arguments.toArray()).mustRefuse();
      String range = plain(option.low()) + " to " + plain(option.high());
      assertTrue(line.contains(range) || line.contains("is not a"), line + " without " + range);
      assertTrue(line.contains(option.option()), line);
    }
  }

  private static String plain(double end) {
    return end == Math.rint(end)
        ? NumberText.count(end)
        : new BigDecimal(Double.toString(end)).toPlainString().replaceAll("0+$", "");
  }

  private static List<String> outside(Ranged option) {
    if (option.whole()) {
      return List.of(
          whole(option.low() - 1),
          "-1",
          option.high() < Integer.MAX_VALUE || option.high() > 1e10
              ? whole(option.high() + 1)
              : "99999999999",
          "1.5",
          "NaN");
    }
    return List.of(
        "NaN",
        "Infinity",
        "-Infinity",
        Double.toString(Math.nextDown(option.low())),
        Double.toString(Math.nextUp(option.high())),
        "1e300",
        "-1");
  }

  private static String whole(double number) {
    return new BigDecimal(number).toPlainString();
  }

  @Test
  void everyNumericOptionIsTried() {
    Set<String> tried = OPTIONS.stream().map(Ranged::name).collect(Collectors.toSet());
    tried.addAll(OTHERS);
    Set<String> known = new TreeSet<>();
    commands().forEach(command -> known.addAll(numericOptions(command)));
    assertEquals(known, new TreeSet<>(tried));
  }

  private static Stream<CommandLine> commands() {
    Stream<Object> own =
        Stream.of(
            new TouchCommand(),
            new ReplayCommand(),
            new InfoCommand(),
            new RenderCommand(),
            new DevicesCommand());
    Stream<Object> provided =
        ServiceLoader.load(CommandProvider.class).stream()
            .map(provider -> provider.get().command());
    return Stream.concat(own, provided).map(CommandLine::new);
  }

  private static List<String> numericOptions(CommandLine command) {
    return command.getCommandSpec().options().stream()
        .filter(option -> isNumeric(option))
        .map(option -> command.getCommandName() + " " + option.longestName())
        .toList();
  }

  private static boolean isNumeric(OptionSpec option) {
    Class<?>[] types = option.auxiliaryTypes();
    String type = types[types.length - 1].getSimpleName().toLowerCase(Locale.ROOT);
    return Set.of("int", "integer", "long", "float", "double").contains(type);
  }

  @Test
  void aStiffnessThatNoForceFitsIsRefusedInAMaterialToo() {
    for (String stiffness : new String[] {"1e300", "1e7", "1e-300", "-1", "NaN"}) {
      String line =
          CommandRun.of(
                  (Object[]) (REPLAY + " --material sphere=stiffness:" + stiffness).split(" "))
              .mustRefuse();
      assertTrue(line.contains("0.000001 to 1,000,000"), line);
    }
  }

  @Test
  void aStepOfSamplesThatKeepsAFrameFromItsEndIsRefused() {
    for (String step : new String[] {"1e-300", "0", "-1", "1e300", "NaN"}) {
      String line =
          CommandRun.of(
                  (Object[]) (REPLAY + " --solver paper --collision sampled:" + step).split(" "))
              .mustRefuse();
      assertTrue(line.contains("0.001 to 1,000"), line);
    }
  }
}
