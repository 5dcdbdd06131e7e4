package org.palpate.documents;

import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.palpate.app.PalpateCommandLine;
import picocli.CommandLine;
import picocli.CommandLine.MissingParameterException;
import picocli.CommandLine.ParameterException;

/** Finds the command lines of a text and parses them as the program does, without running them. */
final class CommandLines {
  /** The program, by the launcher or by the jar, after settings of the environment. */
  private static final Pattern PROGRAM =
      Pattern.compile("(?:\\w+=\\S+ )*(?:\\./palpate|java .*-jar target/palpate\\.jar)(?: (.*))?");

  private static final Pattern WORD = Pattern.compile("'([^']*)'|([^\\s']+)");
  private static final String COMMENT = "\\s+#.*";

  private static final CommandLine PALPATE = PalpateCommandLine.newParser();

  private CommandLines() {}

  /** Returns the arguments of each command line of a block, wrapped lines joined. */
  static List<List<String>> of(String block) {
    List<List<String>> found = new ArrayList<>();
    for (String line : block.replaceAll("\\\\\n\\s*", "").lines().toList()) {
      Matcher matcher = PROGRAM.matcher(line.replaceAll(COMMENT, "").strip());
      if (matcher.matches()) {
        found.add(words(matcher.group(1) == null ? "" : matcher.group(1)));
      }
    }
    return found;
  }

  /** Splits a line into words as the shell does; single quotes keep blanks. */
  static List<String> words(String line) {
    List<String> words = new ArrayList<>();
    StringBuilder word = new StringBuilder();
    Matcher matcher = WORD.matcher(line);
    int end = 0;
    while (matcher.find()) {
      if (matcher.start() > end && !word.isEmpty()) {
        words.add(word.toString());
        word.setLength(0);
      }
      word.append(matcher.group(1) != null ? matcher.group(1) : matcher.group(2));
      end = matcher.end();
    }
    if (!word.isEmpty()) {
      words.add(word.toString());
    }
    return words;
  }

  /**
   * Says what is wrong with the arguments of a command line; empty if nothing is.
   *
   * @param whole whether required options must be there
   */
  static String fault(List<String> arguments, boolean whole) {
    if (arguments.isEmpty()) {
      return "";
    }
    if (arguments.get(0).equals("test")) {
      return faultOfTest(arguments);
    }
    List<String> all = new ArrayList<>(arguments);
    if (arguments.get(0).startsWith("-") && !arguments.get(0).equals("--help")) {
      all.add(0, "touch");
    }
    try {
      PALPATE.parseArgs(all.toArray(String[]::new));
      return "";
    } catch (MissingParameterException e) {
      return whole ? e.getMessage() : "";
    } catch (ParameterException e) {
      return e.getMessage();
    }
  }

  /** The launcher gives what follows {@code test} to Maven. */
  private static String faultOfTest(List<String> arguments) {
    for (String argument : arguments.subList(1, arguments.size())) {
      if (!argument.startsWith("-")) {
        return "not an option of Maven: " + argument;
      }
    }
    return "";
  }

  /** Whether a word is the name of a command. */
  static boolean isCommand(String word) {
    return PALPATE.getSubcommands().containsKey(word);
  }

  /** Whether any command has the option. */
  static boolean isOption(String name) {
    return PALPATE.getSubcommands().values().stream()
        .anyMatch(command -> command.getCommandSpec().findOption(name) != null);
  }
}
