package org.palpate.io.scene;

import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.TreeSet;
import org.palpate.geometry.Vec3;
import org.palpate.io.volume.VolumeFormatException;

/** The fields of a JSON object, whose errors name the file and the key. */
final class JsonFields {
  private final Path file;
  private final String path;
  private final Map<?, ?> fields;

  /**
   * Creates the fields of a value.
   *
   * @param path the key that leads to the object; empty for the whole file
   * @param known every key that the object may have
   * @throws VolumeFormatException if the value is no object, or has another key
   */
  JsonFields(Path file, String path, Object value, Set<String> known) throws VolumeFormatException {
    this.file = file;
    this.path = path;
    if (!(value instanceof Map<?, ?> map)) {
      throw refusal(path.isEmpty() ? "the scene" : path, "must be an object in braces");
    }
    fields = map;
    for (Object key : map.keySet()) {
      if (!known.contains(key)) {
        throw new VolumeFormatException(
            "there is no key " + key((String) key),
            file,
            "leave it out; choose from " + String.join(", ", new TreeSet<>(known)));
      }
    }
  }

  /** Returns the path of a key from the top of the file. */
  String key(String name) {
    return path.isEmpty() ? name : path + "." + name;
  }

  /** Whether a key is present. */
  boolean has(String name) {
    return fields.containsKey(name);
  }

  /** Returns the value of a key as it was read. */
  Object value(String name) {
    return fields.get(name);
  }

  /** Returns the error of a key. */
  VolumeFormatException refusal(String key, String must) {
    return new VolumeFormatException(key + " " + must, file, "correct it in the file");
  }

  /** Returns a text that must be present. */
  String text(String name) throws VolumeFormatException {
    return optionalText(name).orElseThrow(() -> refusal(key(name), "is missing"));
  }

  /** Returns a text, which must not be blank. */
  Optional<String> optionalText(String name) throws VolumeFormatException {
    if (!has(name)) {
      return Optional.empty();
    }
    if (value(name) instanceof String text && !text.isBlank()) {
      return Optional.of(text);
    }
    throw refusal(key(name), "must be a text in quotes that is not blank");
  }

  /** Returns a number above 0. */
  OptionalDouble positive(String name) throws VolumeFormatException {
    if (!has(name)) {
      return OptionalDouble.empty();
    }
    if (value(name) instanceof Double number && number > 0 && Double.isFinite(number)) {
      return OptionalDouble.of(number);
    }
    throw refusal(key(name), "must be a number above 0");
  }

  /** Returns an array of numbers of a fixed length. */
  double[] numbers(String name, int count) throws VolumeFormatException {
    double[] numbers = new double[count];
    boolean isRight = value(name) instanceof List<?> list && list.size() == count;
    for (int n = 0; isRight && n < count; n++) {
      isRight = ((List<?>) value(name)).get(n) instanceof Double number && Double.isFinite(number);
      numbers[n] = isRight ? (Double) ((List<?>) value(name)).get(n) : 0;
    }
    if (!isRight) {
      throw refusal(key(name), "must be an array of " + count + " finite numbers");
    }
    return numbers;
  }

  /** Returns a vector. */
  Optional<Vec3> vector(String name) throws VolumeFormatException {
    if (!has(name)) {
      return Optional.empty();
    }
    double[] v = numbers(name, 3);
    return Optional.of(new Vec3(v[0], v[1], v[2]));
  }

  /** Returns the elements of an array, which are objects or texts; none if the key is absent. */
  List<?> array(String name) throws VolumeFormatException {
    if (!has(name)) {
      return List.of();
    }
    if (value(name) instanceof List<?> list) {
      return list;
    }
    throw refusal(key(name), "must be an array in brackets");
  }
}
