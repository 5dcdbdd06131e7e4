package org.palpate.io.table;

import com.fasterxml.jackson.core.JsonFactory;
import com.fasterxml.jackson.core.JsonGenerator;
import com.fasterxml.jackson.core.StreamWriteFeature;
import com.fasterxml.jackson.core.util.DefaultIndenter;
import com.fasterxml.jackson.core.util.DefaultPrettyPrinter;
import java.io.IOException;
import java.io.OutputStream;
import java.util.List;
import java.util.Map;
import org.palpate.io.file.NumberText;

/**
 * Writes reports as JSON: UTF-8, indented by two spaces, line feeds, doubles as {@link NumberText}
 * writes them. A number that is not finite becomes null because JSON has no other.
 */
public final class ReportJson {
  private static final JsonFactory FACTORY =
      JsonFactory.builder().enable(StreamWriteFeature.USE_FAST_DOUBLE_WRITER).build();

  private ReportJson() {}

  /**
   * Writes one object and a line feed, and leaves the stream open.
   *
   * @param report fields in the map's order; values are strings, numbers, booleans, null, and maps
   *     and lists of these
   */
  public static void write(Map<String, ?> report, OutputStream stream) throws IOException {
    try (JsonGenerator json = FACTORY.createGenerator(stream)) {
      json.disable(JsonGenerator.Feature.AUTO_CLOSE_TARGET);
      DefaultIndenter indenter = new DefaultIndenter("  ", "\n");
      json.setPrettyPrinter(
          new DefaultPrettyPrinter()
              .withObjectIndenter(indenter)
              .withArrayIndenter(DefaultPrettyPrinter.FixedSpaceIndenter.instance));
      writeValue(report, json);
      json.writeRaw('\n');
    }
  }

  private static void writeValue(Object value, JsonGenerator json) throws IOException {
    if (value instanceof Map<?, ?> map) {
      writeObject(map, json);
    } else if (value instanceof List<?> list) {
      writeArray(list, json);
    } else if (value instanceof Double number) {
      writeDouble(number, json);
    } else if (value instanceof Long || value instanceof Integer) {
      json.writeNumber(((Number) value).longValue());
    } else if (value instanceof Boolean flag) {
      json.writeBoolean(flag);
    } else if (value == null) {
      json.writeNull();
    } else {
      json.writeString(value.toString());
    }
  }

  private static void writeObject(Map<?, ?> map, JsonGenerator json) throws IOException {
    json.writeStartObject();
    for (Map.Entry<?, ?> field : map.entrySet()) {
      json.writeFieldName(field.getKey().toString());
      writeValue(field.getValue(), json);
    }
    json.writeEndObject();
  }

  private static void writeArray(List<?> list, JsonGenerator json) throws IOException {
    json.writeStartArray();
    for (Object element : list) {
      writeValue(element, json);
    }
    json.writeEndArray();
  }

  private static void writeDouble(double value, JsonGenerator json) throws IOException {
    if (Double.isFinite(value)) {
      json.writeNumber(value);
    } else {
      json.writeNull();
    }
  }
}
