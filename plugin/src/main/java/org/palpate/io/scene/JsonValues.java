package org.palpate.io.scene;

import com.fasterxml.jackson.core.JsonFactory;
import com.fasterxml.jackson.core.JsonParseException;
import com.fasterxml.jackson.core.JsonParser;
import com.fasterxml.jackson.core.JsonToken;
import com.fasterxml.jackson.core.StreamReadFeature;
import com.fasterxml.jackson.core.exc.StreamConstraintsException;
import com.fasterxml.jackson.core.io.JsonEOFException;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.palpate.io.volume.VolumeFormatException;

/** Reads a JSON file into maps, lists, strings, doubles and booleans. */
final class JsonValues {
  private static final long MOST_BYTES = 1 << 24;

  private static final JsonFactory FACTORY =
      JsonFactory.builder().enable(StreamReadFeature.STRICT_DUPLICATE_DETECTION).build();

  private JsonValues() {}

  /**
   * Returns the only value of a file; null for null.
   *
   * @throws VolumeFormatException if it cannot be read, is too long, or is no JSON
   */
  static Object read(Path file) throws VolumeFormatException {
    try {
      if (Files.size(file) > MOST_BYTES) {
        throw new VolumeFormatException(
            "the file is too long for a scene", file, "give a scene file, not a volume");
      }
      try (JsonParser json = FACTORY.createParser(Files.readAllBytes(file))) {
        json.nextToken();
        Object value = value(json);
        if (json.nextToken() != null) {
          throw refusal(file, json, "something follows the end of the scene", null);
        }
        return value;
      } catch (JsonEOFException e) {
        throw refusal(file, e.getProcessor(), "the file is no JSON, it ends too early", e);
      } catch (JsonParseException e) {
        throw refusal(file, e.getProcessor(), "the file is no JSON, " + e.getOriginalMessage(), e);
      } catch (StreamConstraintsException e) {
        throw new VolumeFormatException(
            "the file is nested too deeply for a scene, or has too long a name or number",
            file,
            "give a scene file",
            e);
      }
    } catch (VolumeFormatException e) {
      throw e;
    } catch (IOException e) {
      throw new VolumeFormatException(
          "the scene cannot be read", file, "check that the file exists and may be read", e);
    }
  }

  private static VolumeFormatException refusal(
      Path file, JsonParser json, String what, Exception cause) {
    return new VolumeFormatException(
        what, file, "mend line " + json.currentLocation().getLineNr() + " of the file", cause);
  }

  private static Object value(JsonParser json) throws IOException {
    JsonToken token = json.currentToken();
    if (token == null) {
      throw new JsonParseException(json, "it is empty");
    }
    return switch (token) {
      case START_OBJECT -> object(json);
      case START_ARRAY -> array(json);
      case VALUE_STRING -> json.getText();
      case VALUE_NUMBER_INT, VALUE_NUMBER_FLOAT -> json.getDoubleValue();
      case VALUE_TRUE -> true;
      case VALUE_FALSE -> false;
      case VALUE_NULL -> null;
      default -> throw new JsonParseException(json, "unexpected " + token);
    };
  }

  private static Map<String, Object> object(JsonParser json) throws IOException {
    Map<String, Object> fields = new LinkedHashMap<>();
    while (json.nextToken() != JsonToken.END_OBJECT) {
      String name = json.currentName();
      json.nextToken();
      fields.put(name, value(json));
    }
    return fields;
  }

  private static List<Object> array(JsonParser json) throws IOException {
    List<Object> elements = new ArrayList<>();
    while (json.nextToken() != JsonToken.END_ARRAY) {
      elements.add(value(json));
    }
    return elements;
  }
}
