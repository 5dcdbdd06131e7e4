package org.palpate.app.options;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.palpate.scene.DeformationColour;
import org.palpate.scene.DeformationColour.Measure;
import org.palpate.scene.surface.GreyRange;

class SurfaceOptionsTest {
  private static final String GREY = "--phantom=sphere:16:grey";

  @TempDir private Path folder;

  private static SurfaceOptions options(String... arguments) {
    return Given.options(new SurfaceOptions(), arguments);
  }

  @Test
  void eachKnownSourceIsAllowed() {
    options().check();
    options("--surface=grey").check();
    options("--surface=bits").check();
  }

  @ParameterizedTest
  @ValueSource(strings = {"gold", "Grey", ""})
  void anotherSourceIsRefused(String text) {
    Given.refuses(
        "there is no such source of a surface: --surface " + text + ": choose grey or bits",
        () -> options("--surface=" + text).check());
  }

  @Test
  void deformedSurfacesAreColouredAsAskedFor() {
    assertTrue(options().deformed().isEmpty());
    assertEquals(
        Optional.of(new DeformationColour(Measure.STRAIN, 0.3)),
        options("--colour-by=strain").deformed());
    assertEquals(
        Optional.of(new DeformationColour(Measure.DISPLACEMENT, 2.5)),
        options("--colour-by=displacement:2.5").deformed());
  }

  @ParameterizedTest
  @ValueSource(strings = {"stress", "strain:0", "strain:x", "strain:1:2", "displacement:-1", ""})
  void otherColoursOfDeformedSurfacesAreRefused(String text) {
    Given.refuses(
        "the colours of deformed surfaces cannot be read: --colour-by "
            + text
            + ": write displacement or strain, or the value of the last colour too, as in"
            + " strain:0.2",
        () -> options("--colour-by=" + text).check());
  }

  @Test
  void coloursNeedAnElasticSegment() {
    Given.refuses(
        "no segment is elastic: --colour-by: add --elastic NAME=young:PA, or leave it out",
        () -> options("--colour-by=strain").checkDeformed(new ElasticOptions()));
    options("--colour-by=strain")
        .checkDeformed(Given.options(new ElasticOptions(), "--elastic=block=young:20e3"));
    options().checkDeformed(new ElasticOptions());
  }

  @Test
  void greyValuesAreUsedIfAskedForOrByDefault() throws IOException {
    String[] volume = {GREY, "--segment=band=300..700", "--segment=all=nonzero"};
    assertEquals(List.of(), options("--surface=bits").greys(Given.source(volume), true));
    VolumeSource untouched = Given.source(volume);
    assertEquals(List.of(), options().greys(untouched, false));
    assertFalse(untouched.hasGreyValues());
    for (SurfaceOptions chosen : List.of(options(), options("--surface=grey"))) {
      VolumeSource source = Given.source(volume);
      List<Optional<GreyRange>> greys = chosen.greys(source, true);
      assertEquals(2, greys.size());
      GreyRange band = greys.get(0).orElseThrow();
      assertEquals(300, band.low());
      assertEquals(700, band.high());
      assertEquals(source.greyValues(), band.volume());
      assertTrue(greys.get(1).isEmpty(), "not made by a range");
    }
  }

  @Test
  void aMaskIsNoReasonForAGreySurfaceByDefault() throws IOException {
    Path mask = Given.nrrd(folder.resolve("m.nrrd"), "uint8", "2 2 2", "0 1 0 1 0 1 0 1");
    String[] volume = {"--volume", mask.toString(), "--segment=a=>=1"};
    assertEquals(List.of(), options().greys(Given.source(volume), true));
    VolumeSource read = Given.source(volume);
    read.greyValues();
    assertEquals(List.of(), options().greys(read, true));
    assertEquals(1, options("--surface=grey").greys(Given.source(volume), false).size());
  }

  @Test
  void withoutARangeThereIsNoGreySurface() throws IOException {
    VolumeSource labels = Given.source("--phantom=sphere:16");
    assertEquals(List.of(), options().greys(labels, true));
    String line =
        "a surface of grey values needs a segment made by a threshold: --surface grey: choose one"
            + " with --segment NAME=>=VALUE, or leave --surface out";
    Given.refuses(line, () -> options("--surface=grey").checkPossible(labels));
    Given.refuses(line, () -> options("--surface=grey").greys(labels, false));
    options("--surface=bits").checkPossible(labels);
    options("--surface=grey").checkPossible(Given.source(GREY, "--segment=s=>=500"));
  }
}
