package org.palpate.documents;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;

/** A page of GitHub's Markdown, taken apart: prose, blocks of code, code spans, links, headings. */
final class Page {
  private static final Pattern HEADING = Pattern.compile("#{1,6} +(.*?) *#*");
  private static final Pattern LINK = Pattern.compile("\\[[^\\]]*\\]\\(([^)\\s]+)\\)");
  private static final Pattern SPAN = Pattern.compile("`([^`]+)`");
  private static final Pattern LIST_ITEM = Pattern.compile(" *([-*]|\\d+\\.) .*");
  private static final String INDENT = "    ";

  /**
   * A fenced or indented block of code.
   *
   * @param language the word after the fence; empty for an indented block
   * @param text whole lines
   */
  record Block(String language, String text) {}

  private final Path file;
  private final List<String> lines;
  private final List<String> prose = new ArrayList<>();
  private final List<Block> blocks = new ArrayList<>();

  private Page(Path file) throws IOException {
    this.file = file;
    lines = Files.readAllLines(file);
    split();
  }

  static Page read(Path file) throws IOException {
    return new Page(file);
  }

  Path file() {
    return file;
  }

  /** Returns the number of lines. */
  int length() {
    return lines.size();
  }

  /** Returns the lines outside blocks of code. */
  List<String> prose() {
    return prose;
  }

  List<Block> blocks() {
    return blocks;
  }

  /** Returns the text of every code span. */
  List<String> spans() {
    List<String> spans = new ArrayList<>();
    for (String paragraph : paragraphs()) {
      Matcher matcher = SPAN.matcher(paragraph);
      while (matcher.find()) {
        spans.add(matcher.group(1).strip());
      }
    }
    return spans;
  }

  /** Returns the target of every link and image. */
  List<String> links() {
    List<String> links = new ArrayList<>();
    for (String paragraph : paragraphs()) {
      Matcher matcher = LINK.matcher(SPAN.matcher(paragraph).replaceAll("code"));
      while (matcher.find()) {
        links.add(matcher.group(1));
      }
    }
    return links;
  }

  /** Returns the anchors of the headings as GitHub makes them. */
  List<String> anchors() {
    Map<String, Integer> uses = new HashMap<>();
    List<String> anchors = new ArrayList<>();
    for (String line : prose) {
      Matcher matcher = HEADING.matcher(line);
      if (matcher.matches()) {
        String slug = slug(matcher.group(1));
        int earlier = uses.merge(slug, 1, Integer::sum) - 1;
        anchors.add(earlier == 0 ? slug : slug + "-" + earlier);
      }
    }
    return anchors;
  }

  private static String slug(String heading) {
    return heading
        .replaceAll("\\[([^\\]]*)\\]\\([^)]*\\)", "$1")
        .toLowerCase(Locale.ROOT)
        .replaceAll("[^\\p{L}\\p{N} _-]", "")
        .replace(' ', '-');
  }

  /**
   * Returns the prose in pieces that hold whole sentences: paragraphs, list items and headings.
   * Tables are left out, and a code span or the target of a link counts as one word.
   */
  List<String> sentences() {
    String text = String.join("\n", prose).replaceAll("(?m)^\\|.*$", "");
    return Stream.of(text.split("\n\\s*\n|\n(?= *(?:[-*]|\\d+\\.) |#)"))
        .map(piece -> SPAN.matcher(piece.replace('\n', ' ')).replaceAll("code"))
        .map(piece -> piece.replaceAll("\\]\\([^)]*\\)", "]"))
        .toList();
  }

  /** Returns runs of prose joined to one line each, because spans and links may be wrapped. */
  private List<String> paragraphs() {
    return String.join("\n", prose).replaceAll("(?<!\n)\n(?![\n|#])", " ").lines().toList();
  }

  private void split() {
    boolean listed = false;
    for (int n = 0; n < lines.size(); n++) {
      String line = lines.get(n);
      if (line.startsWith("```")) {
        n = addFenced(n);
      } else if (!listed && isIndented(line) && (n == 0 || lines.get(n - 1).isBlank())) {
        n = addIndented(n);
      } else {
        listed = LIST_ITEM.matcher(line).matches() || (listed && isContinued(line));
        prose.add(line);
      }
    }
  }

  /** Whether a list goes on: by a blank or an indented line. */
  private static boolean isContinued(String line) {
    return line.isBlank() || line.startsWith("  ");
  }

  private static boolean isIndented(String line) {
    return line.startsWith(INDENT) && !line.isBlank();
  }

  /** Returns the index of the closing fence. */
  private int addFenced(int opening) {
    int end = opening + 1;
    while (end < lines.size() && !lines.get(end).startsWith("```")) {
      end++;
    }
    addBlock(lines.get(opening).substring(3).strip(), lines.subList(opening + 1, end));
    return end;
  }

  /** Returns the index of the last line of the block. */
  private int addIndented(int first) {
    int end = first;
    while (end < lines.size() && (isIndented(lines.get(end)) || lines.get(end).isBlank())) {
      end++;
    }
    List<String> block = lines.subList(first, end);
    addBlock("", block.stream().map(l -> l.isBlank() ? "" : l.substring(INDENT.length())).toList());
    return end - 1;
  }

  private void addBlock(String language, List<String> block) {
    prose.add("");
    blocks.add(new Block(language, String.join("\n", block) + "\n"));
  }

  @Override
  public String toString() {
    return Sources.root().relativize(file).toString();
  }
}
