package org.palpate.app.command;

import java.util.Arrays;
import java.util.Locale;
import org.palpate.scene.Stereo;
import picocli.CommandLine.ITypeConverter;
import picocli.CommandLine.TypeConversionException;

/** Converts the name of a kind of stereo, with hyphens. */
final class StereoConverter implements ITypeConverter<Stereo> {
  @Override
  public Stereo convert(String name) {
    return Arrays.stream(Stereo.values())
        .filter(stereo -> name(stereo).equals(name))
        .findFirst()
        .orElseThrow(
            () ->
                new TypeConversionException(
                    "there is no " + name + ": choose off, anaglyph or side-by-side"));
  }

  private static String name(Stereo stereo) {
    return stereo.name().toLowerCase(Locale.ROOT).replace('_', '-');
  }
}
