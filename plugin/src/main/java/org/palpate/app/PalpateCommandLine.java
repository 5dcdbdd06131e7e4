package org.palpate.app;

import java.io.IOException;
import java.io.PrintStream;
import java.io.PrintWriter;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.ServiceLoader;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.palpate.app.command.DevicesCommand;
import org.palpate.app.command.InfoCommand;
import org.palpate.app.command.RenderCommand;
import org.palpate.app.command.ReplayCommand;
import org.palpate.app.command.TouchCommand;
import org.palpate.app.process.OutputPaths;
import org.palpate.app.process.PalpateException;
import org.palpate.app.process.VersionProvider;
import org.palpate.io.file.WriteFailedException;
import org.palpate.io.table.CsvFormatException;
import org.palpate.io.volume.VolumeFormatException;
import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.MissingParameterException;
import picocli.CommandLine.Model.ArgSpec;
import picocli.CommandLine.Model.OptionSpec;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.ParseResult;
import picocli.CommandLine.TypeConversionException;
import picocli.CommandLine.UnmatchedArgumentException;

/**
 * Finds the command that the user asks for, runs it, and turns each failure into one line and an
 * exit code. One thread.
 */
public final class PalpateCommandLine {
  private static final String DEFAULT_COMMAND = "touch";
  private static final Pattern CHOICES =
      Pattern.compile("expected one of \\[(.*)] \\(case-insensitive\\) but was ('.*')");
  private static final Set<String> ROOT_OPTIONS = Set.of("-h", "--help", "-V", "--version");

  private final PrintStream err;
  private final CommandLine commandLine;

  /** Creates the command line with all commands, which print to the given streams. */
  public PalpateCommandLine(PrintStream out, PrintStream err) {
    this.err = err;
    commandLine =
        newParser()
            .setOut(new PrintWriter(out, true, StandardCharsets.UTF_8))
            .setErr(new PrintWriter(err, true, StandardCharsets.UTF_8))
            .setParameterExceptionHandler(this::handleWrongUse)
            .setExecutionExceptionHandler(this::handleFailure);
  }

  /** Returns a parser of all commands, which reports wrong use by exceptions. */
  public static CommandLine newParser() {
    CommandLine parser = new CommandLine(new Root());
    List.of(
            new TouchCommand(),
            new ReplayCommand(),
            new InfoCommand(),
            new RenderCommand(),
            new DevicesCommand())
        .forEach(parser::addSubcommand);
    ServiceLoader.load(CommandProvider.class)
        .forEach(provider -> parser.addSubcommand(provider.command()));
    return parser
        .setAbbreviatedOptionsAllowed(false)
        .setCaseInsensitiveEnumValuesAllowed(true)
        .registerConverter(Path.class, PalpateCommandLine::path);
  }

  /**
   * Runs one command.
   *
   * @param arguments the arguments of the process; without a command they are those of {@code
   *     touch}
   * @return 0 if the command succeeded, 1 if it failed at run time, 2 for wrong use or bad input
   */
  public int run(String... arguments) {
    try {
      return commandLine.execute(withDefaultCommand(arguments));
    } catch (OutOfMemoryError e) {
      print(
          "palpate: out of memory: palpate: give Java more memory, for example"
              + " JAVA_TOOL_OPTIONS=-Xmx8g",
          e,
          isDebug(arguments));
      return PalpateException.FAILED;
    }
  }

  private static String[] withDefaultCommand(String... arguments) {
    boolean namesNoCommand =
        arguments.length == 0
            || (arguments[0].startsWith("-") && !ROOT_OPTIONS.contains(arguments[0]));
    return namesNoCommand
        ? Stream.concat(Stream.of(DEFAULT_COMMAND), Arrays.stream(arguments)).toArray(String[]::new)
        : arguments;
  }

  private int handleWrongUse(ParameterException e, String... arguments) {
    CommandLine command = e.getCommandLine();
    String name = command.getCommandSpec().qualifiedName();
    print(
        "palpate: " + oneLine(reason(e)) + ": " + name + ": see " + name + " --help",
        e,
        isDebug(arguments));
    return PalpateException.WRONG_USE;
  }

  private static String reason(ParameterException e) {
    if (e instanceof UnmatchedArgumentException unmatched && !unmatched.isUnknownOption()) {
      String kind =
          unmatched.getCommandLine().getParent() == null ? "no such command " : "unexpected ";
      return kind + unmatched.getUnmatched().get(0);
    }
    if (e instanceof MissingParameterException missing && !missing.getMissing().isEmpty()) {
      return "missing " + nameOf(missing.getMissing().get(0));
    }
    return inPlainWords(e.getMessage());
  }

  /** Returns a message of picocli without the names of Java types and constants. */
  private static String inPlainWords(String message) {
    String numbers =
        message
            .replaceFirst(" is not a double$", " is not a number")
            .replaceFirst(" is not an? (int|long)$", " is not a whole number");
    Matcher choices = CHOICES.matcher(numbers);
    return choices.replaceFirst(
        match ->
            Matcher.quoteReplacement(
                match.group(2) + " is none of " + match.group(1).toLowerCase(Locale.ROOT)));
  }

  /** Converts a path; an empty one, as of a shell variable that is not set, means no folder. */
  private static Path path(String text) {
    if (text.isBlank()) {
      throw new TypeConversionException("the path is empty");
    }
    return Path.of(text);
  }

  private static String nameOf(ArgSpec missing) {
    return missing instanceof OptionSpec option
        ? option.longestName() + " " + option.paramLabel()
        : missing.paramLabel();
  }

  private int handleFailure(Exception e, CommandLine command, ParseResult result) {
    boolean debug = isDebug(result.originalArgs().toArray(String[]::new));
    if (e instanceof PalpateException known) {
      print("palpate: " + oneLine(known.getMessage()), e, debug);
      return known.exitCode();
    }
    if (e instanceof VolumeFormatException || e instanceof CsvFormatException) {
      print("palpate: " + oneLine(e.getMessage()), e, debug);
      return PalpateException.WRONG_USE;
    }
    if (e instanceof WriteFailedException written) {
      print(
          "palpate: " + oneLine(OutputPaths.failed(written.target(), written).getMessage()),
          e,
          debug);
      return PalpateException.FAILED;
    }
    String where = command.getCommandSpec().qualifiedName();
    if (e instanceof IOException) {
      String what = "reading or writing failed (" + e.getMessage() + ")";
      print("palpate: " + oneLine(what) + ": " + where + ": check the disk", e, debug);
      return PalpateException.FAILED;
    }
    print(
        "palpate: "
            + oneLine(e.toString())
            + ": "
            + where
            + ": run it again with --debug and report the output",
        e,
        debug);
    return PalpateException.FAILED;
  }

  private void print(String line, Throwable e, boolean debug) {
    err.println(line);
    if (debug) {
      e.printStackTrace(err);
    }
  }

  private static boolean isDebug(String... arguments) {
    return Arrays.asList(arguments).contains("--debug");
  }

  private static String oneLine(String text) {
    return text.replaceAll("\\R+", " ");
  }

  /** The root command, which exists for its help. */
  @Command(
      name = "palpate",
      description = "Touch a segmented 3-D scan with a haptic device. Not a medical device.",
      mixinStandardHelpOptions = true,
      versionProvider = VersionProvider.class,
      synopsisSubcommandLabel = "[COMMAND]",
      footer = {
        "",
        "Without a command, palpate runs touch: a live session on the built-in head phantom.",
        "",
        "Examples:",
        "  palpate",
        "  palpate info --volume scan.nrrd",
        "  palpate touch --volume scan.nrrd --segment 'bone=>=1500'",
        "  palpate touch --help"
      })
  private static final class Root {}
}
