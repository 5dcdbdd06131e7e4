package org.palpate.endtoend;

import com.fasterxml.jackson.core.JsonFactory;
import com.fasterxml.jackson.core.JsonParser;
import com.fasterxml.jackson.core.JsonToken;
import java.io.IOException;
import java.nio.file.Path;
import java.util.Map;
import java.util.TreeMap;

/** Reads a JSON object as paths and values: {@code /segments/0/voxels} is {@code 336108}. */
final class FlatJson {
  private FlatJson() {}

  static Map<String, String> read(Path file) throws IOException {
    Map<String, String> values = new TreeMap<>();
    try (JsonParser parser = new JsonFactory().createParser(file.toFile())) {
      while (parser.nextToken() != null) {
        JsonToken token = parser.currentToken();
        if (token.isScalarValue()) {
          values.put(parser.getParsingContext().pathAsPointer().toString(), parser.getText());
        }
      }
    }
    return values;
  }

  /** Returns the first number whose path ends with {@code keys}, such as {@code carved/sphere}. */
  static double number(Path file, String keys) throws IOException {
    try (JsonParser parser = new JsonFactory().createParser(file.toFile())) {
      while (parser.nextToken() != null) {
        String path = parser.getParsingContext().pathAsPointer().toString();
        if (parser.currentToken().isNumeric() && path.endsWith("/" + keys)) {
          return parser.getDoubleValue();
        }
      }
    }
    throw new AssertionError(file + " has no number " + keys);
  }
}
