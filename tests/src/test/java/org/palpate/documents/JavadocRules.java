package org.palpate.documents;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * The rules for sentences that a machine can decide. A comment begins with a verb or a noun phrase,
 * and no sentence is longer than {@link #MAX_WORDS}.
 */
final class JavadocRules {
  /** The most words of a sentence. */
  static final int MAX_WORDS = 35;

  /** Words that begin a fragment instead of a sentence. */
  private static final Set<String> NOT_FIRST =
      Set.of(
          "What", "How", "That", "Of", "Which", "Whose", "Since", "Where", "And", "But", "Or",
          "So");

  private static final Pattern COMMENT = Pattern.compile("/\\*\\*(.*?)\\*/", Pattern.DOTALL);
  private static final Pattern FIRST_WORD = Pattern.compile("[A-Za-z]+");
  private static final Pattern PARAGRAPH =
      Pattern.compile("\\n\\s*(?=@\\w)|\\n\\s*\\n|</?(?:p|li|ul|ol|tr|td|h\\d)\\b[^>]*>");
  private static final Pattern BLANKS = Pattern.compile("\\s+");
  private static final Pattern SENTENCE_END = Pattern.compile("(?<=[.;:!?])\\s+");

  private JavadocRules() {}

  /** Returns what is wrong with the Javadoc of a source file; empty if nothing is. */
  static List<String> faultsOfSource(String source) {
    List<String> faults = new ArrayList<>();
    Matcher comments = COMMENT.matcher(source);
    while (comments.find()) {
      String text = comments.group(1).replaceAll("(?m)^\\s*\\* ?", "").strip();
      Matcher first = FIRST_WORD.matcher(text);
      if (first.lookingAt() && NOT_FIRST.contains(first.group())) {
        faults.add("begins with " + first.group() + ": " + text.lines().findFirst().orElse(""));
      }
      faults.addAll(longSentences(proseOfJavadoc(text)));
    }
    return faults;
  }

  /** Returns the text of a comment as a page shows it, without tables and drawings. */
  private static String proseOfJavadoc(String text) {
    return text.replaceAll("(?s)<pre>.*?</pre>|<table.*?</table>", "\n\n")
        .replaceAll("(?s)\\{@(?:code|literal) [^}]*}", "code")
        .replaceAll("(?s)\\{@(?!return)\\w+ ([^}]*)}", "$1")
        .replaceAll("(?s)\\{@return ([^}]*)}", "Returns $1.");
  }

  /** Returns the sentences of a text that are too long. */
  static List<String> longSentences(String text) {
    List<String> faults = new ArrayList<>();
    PARAGRAPH
        .splitAsStream(text)
        .flatMap(paragraph -> SENTENCE_END.splitAsStream(paragraph.strip()))
        .filter(sentence -> words(sentence) > MAX_WORDS)
        .forEach(
            sentence ->
                faults.add(words(sentence) + " words: " + sentence.replaceAll("\\s+", " ")));
    return faults;
  }

  private static long words(String sentence) {
    return BLANKS.splitAsStream(sentence.strip()).filter(word -> !word.isEmpty()).count();
  }
}
