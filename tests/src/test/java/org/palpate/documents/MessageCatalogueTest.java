package org.palpate.documents;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;
import org.palpate.documents.MessageSources.Message;

/**
 * Walks all error messages, and compares them with the catalogue {@code docs/messages.csv}. {@code
 * -Dpalpate.recordMessages=true} writes the catalogue instead.
 */
class MessageCatalogueTest {
  private static final Path CATALOGUE = Sources.root().resolve("docs").resolve("messages.csv");

  /** A text that only passes another message on. */
  private static final Pattern PASSED_ON = Pattern.compile("\\{\\w+}");

  /** The beginning of a part of a line: a small letter, a value, an option, or a name. */
  private static final Pattern BEGIN =
      Pattern.compile("[a-z'{\\[\"-].*|(DICOM|OpenGL|Xvfb|Java|JAVA)\\b.*", Pattern.DOTALL);

  @Test
  void everyLineHasAnInputAValueAndARemedy() throws IOException {
    List<String> faults = new ArrayList<>();
    Set<Message> messages = messages();
    for (Message message : messages) {
      faults.addAll(faults(message));
    }
    assertEquals(List.of(), faults);
    assertTrue(messages.size() > 300, "found only " + messages.size());
  }

  @Test
  void theCatalogueListsEveryMessage() throws IOException {
    Set<String> lines = new TreeSet<>();
    for (Message message : messages()) {
      lines.add(
          String.join(",", message.source(), quoted(message.what()), quoted(message.remedy())));
    }
    String text = "class,message,remedy\n" + String.join("\n", lines) + "\n";
    if (Boolean.getBoolean("palpate.recordMessages")) {
      Files.writeString(CATALOGUE, text);
    }
    assertEquals(
        text, Files.readString(CATALOGUE), "write it anew with -Dpalpate.recordMessages=true");
  }

  @Test
  void aMessageWithoutOneOfItsPartsIsFound() throws IOException {
    String source =
        """
        package a;
        class A {
          void a(String x) { throw PalpateException.wrongUse("it is wrong", "here", ""); }
          void b(String x) { throw new VolumeFormatException("Wrong: " + x, x, "mend it."); }
          void c(String what) { throw new VolumeFormatException(what, file, "mend it"); }
          void d(int n) { c("there are " + n + " axes"); }
        }
        """;
    Set<Message> found = MessageSources.of(Map.of("a.A", source));
    assertEquals(3, found.size(), found::toString);
    List<String> faults = new ArrayList<>();
    found.forEach(message -> faults.addAll(faults(message)));
    assertEquals(4, faults.size(), faults::toString);
    assertTrue(found.contains(new Message("A", "there are {n} axes", "{file}", "mend it")));
  }

  private static List<String> faults(Message message) {
    List<String> faults = new ArrayList<>();
    if (message.where().isEmpty()) {
      return faults; // a sentence of a dialog, or of a library
    }
    if (!(message.what() + message.where()).matches("(?s).*(\\{|--).*")) {
      faults.add("names no input or value: " + message);
    }
    if (message.remedy().isBlank()) {
      faults.add("has no remedy: " + message);
    }
    for (String part : List.of(message.what(), message.remedy())) {
      if (!part.isEmpty() && !BEGIN.matcher(part).matches()) {
        faults.add("begins like a sentence of its own: " + message);
      }
      if (part.endsWith(".") && !part.endsWith("...")) {
        faults.add("ends like a sentence of its own: " + message);
      }
    }
    return faults;
  }

  private static Set<Message> messages() throws IOException {
    Set<Message> messages = MessageSources.of(production());
    messages.removeIf(message -> PASSED_ON.matcher(message.what()).matches());
    return messages;
  }

  private static Map<String, String> production() {
    Map<String, String> production = new TreeMap<>(Sources.classes());
    production.keySet().removeIf(name -> !Sources.isProduction(name));
    return production;
  }

  private static String quoted(String text) {
    return '"' + text.replace("\"", "\"\"") + '"';
  }
}
