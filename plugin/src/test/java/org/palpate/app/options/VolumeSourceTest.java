package org.palpate.app.options;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.OptionalDouble;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.palpate.body.Mobility;
import org.palpate.io.label.SegmentSpec;
import org.palpate.io.volume.VolumeFormatException;
import org.palpate.volume.Segment;
import org.palpate.volume.SegmentedVolume;

class VolumeSourceTest {
  @TempDir private Path folder;

  private VolumeSource labels(String... segments) throws IOException {
    Path file = Given.nrrd(folder.resolve("l.nrrd"), "uint8", "4 2 1", "0 1 1 1 0 7 7 0");
    String[] arguments = new String[2 + segments.length];
    arguments[0] = "--volume";
    arguments[1] = file.toString();
    System.arraycopy(segments, 0, arguments, 2, segments.length);
    return Given.source(arguments);
  }

  private static List<String> counts(SegmentedVolume volume) {
    return volume.segments().stream()
        .map(segment -> segment.name() + " " + segment.bits().solidCount())
        .toList();
  }

  @Test
  void eachLabelIsASegmentUnlessSomeAreAskedFor() throws IOException {
    assertEquals(List.of("label1 3", "label7 2"), counts(Given.segments(labels())));
    assertEquals(
        List.of("both 5", "seven 2"),
        counts(Given.segments(labels("--segment=both=label:1,7", "--segment=seven=>=2"))));
  }

  @Test
  void aSegmentWithoutVoxelsIsNoted() throws IOException {
    StringWriter notes = new StringWriter();
    VolumeSource source = labels("--segment=nine=label:9", "--segment=one=label:1");
    SegmentedVolume found = source.segments(new PrintWriter(notes), false);
    assertEquals(List.of("nine 0", "one 3"), counts(found));
    assertEquals(
        "palpate: segment nine has no voxel: "
            + folder.resolve("l.nrrd")
            + ": palpate info prints its values"
            + System.lineSeparator(),
        notes.toString());
  }

  @Test
  void greyValuesAreReadInTheSamePassIfTheyAreKept() throws IOException {
    VolumeSource source = labels("--segment=one=label:1");
    assertFalse(source.hasGreyValues());
    source.segments(new PrintWriter(new StringWriter()), true);
    assertTrue(source.hasGreyValues());
    Files.delete(folder.resolve("l.nrrd"));
    assertEquals(7, source.greyValues().value(1, 1, 0), "kept although the file is gone");
  }

  @Test
  void namesAndColoursComeFromTheFile() throws IOException {
    Path file = folder.resolve("s.seg.nrrd");
    Files.writeString(
        file,
        """
        NRRD0004
        type: uint8
        dimension: 3
        sizes: 4 1 1
        encoding: ascii
        Segment0_ID:=S0
        Segment0_Name:=Left Jaw
        Segment0_LabelValue:=1
        Segment0_Layer:=0
        Segment0_Color:=1 0 0.5
        Segment1_ID:=S1
        Segment1_Name:=Left Jaw
        Segment1_LabelValue:=3
        Segment1_Layer:=0
        Segment1_Color:=0 1 0
        Segment2_ID:=S2
        Segment2_Name:=Tooth
        Segment2_LabelValue:=4
        Segment2_Layer:=0

        0 1 3 3
        """);
    VolumeSource source = Given.source("--volume", file.toString());
    assertEquals(List.of("Tooth"), source.emptySegments(List.of(1L, 3L)));
    StringWriter notes = new StringWriter();
    List<Segment> segments = source.segments(new PrintWriter(notes), false).segments();
    assertTrue(notes.toString().startsWith("palpate: segment Tooth has no voxel: "), "" + notes);
    assertEquals("Left Jaw", segments.get(0).name());
    assertEquals("Left Jaw-3", segments.get(1).name(), "two segments never share a name");
    assertEquals(0x00FF00, segments.get(1).rgb());
    assertEquals("label9", source.specsOf(List.of(9L)).get(0).name());
    assertEquals(SegmentSpec.ANY_COLOUR, source.specsOf(List.of(9L)).get(0).rgb());
  }

  @Test
  void intensitiesAreRefusedWithAnExample() {
    Given.refuses(
        "no segment is chosen, and the values are intensities from 0 to 1000: phantom"
            + " sphere:16:grey: choose with --segment, for example --segment 'sphere=>=500'",
        () -> Given.segments(Given.source("--phantom=sphere:16:grey")));
  }

  @Test
  void aPhantomIsReadWithoutAFile() throws IOException {
    VolumeSource source = Given.source("--phantom=block:16");
    assertEquals("phantom block:16", source.name());
    assertEquals(List.of(), source.files());
    assertEquals(List.of("block 800", "base 392"), counts(Given.segments(source)));
    assertTrue(source.placements().isEmpty());
    assertTrue(source.placed().isEmpty());
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "cow|no such phantom: --phantom cow: choose head, sphere, shell, plane, torus, maze, block"
            + " or fracture",
        "head:15|phantom edge out of range: --phantom head:15: choose 16 to 4096",
        "head:x|phantom edge is not a number: --phantom head:x: write NAME[:EDGE][:grey]",
        "head:64:grey:1|phantom not understood: --phantom head:64:grey:1: write NAME[:EDGE][:grey]",
        "fracture:63|phantom edge out of range: --phantom fracture:63: choose 64 to 1024",
        "fracture:64:9|number of fragments out of range: --phantom fracture:64:9: choose 2 to 8"
      })
  void aPhantomThatIsNotThereIsRefused(String phantom, String line) {
    Given.refuses(line, () -> Given.source("--phantom=" + phantom));
  }

  @Test
  void theFragmentsOfABrokenBoneAreMovableButTheFirst() throws IOException {
    VolumeSource source = Given.source("--phantom=fracture:64:3:5:0");
    assertEquals("phantom fracture:64:3:5:0", source.name());
    assertEquals(3, source.placements().size());
    assertEquals(Mobility.FIXED, source.placements().get(0).mobility());
    assertEquals(Mobility.MOVABLE, source.placements().get(2).mobility());
    assertTrue(source.placements().get(0).isAtRest());
    assertEquals(3, Given.segments(source).segments().size());
    VolumeSource asked = Given.source("--phantom=fracture:64:3:5:0", "--segment=all=nonzero");
    assertTrue(asked.placed().isEmpty(), "other segments of what the scene shows");
    assertEquals(List.of(), asked.placements());
  }

  @Test
  void twoSegmentsNeverHaveOneName() {
    Given.refuses(
        "two segments have the same name: --segment a=>=1: give each its own name",
        () -> Given.source("--phantom=sphere:16", "--segment=a=nonzero", "--segment=a=>=1"));
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "bone|a segment needs a name",
        "=>=1|a segment needs a name",
        "a=>=many|the values of the segment are not understood",
        "a=9..1|the values of the segment are not understood",
        "a=label:x|labels must be integers",
        "a=label:|labels must be integers"
      })
  void aSegmentOfAnotherFormIsRefused(String text, String what) {
    VolumeFormatException refusal =
        assertThrows(
            VolumeFormatException.class,
            () -> Given.source("--phantom=sphere:16", "--segment=" + text));
    assertTrue(
        refusal.getMessage().startsWith(what + ": --segment " + text + ": write 'bone=>=1500'"),
        refusal.getMessage());
  }

  @Test
  void theThresholdIsThatOfTheOnlySegment() throws IOException {
    assertEquals(OptionalDouble.of(2), labels("--segment=a=>=2").threshold());
    assertEquals(OptionalDouble.empty(), labels("--segment=a=2..5").threshold());
    assertEquals(OptionalDouble.empty(), labels("--segment=a=-inf..5").threshold());
    assertEquals(OptionalDouble.empty(), labels("--segment=a=>=2", "--segment=b=>=3").threshold());
    assertEquals(
        OptionalDouble.of(3),
        labels("--segment=a=label:1", "--segment=b=3..5", "--segment=c=>=1").firstThreshold());
    assertEquals(OptionalDouble.empty(), labels("--segment=a=nonzero").firstThreshold());
  }

  @Test
  void theDigestIsThatOfTheBytesOrOfThePhantom() throws IOException {
    String sphere = Given.source("--phantom=sphere:16").sha256();
    assertTrue(sphere.matches("[0-9a-f]{64}"), sphere);
    assertEquals(sphere, Given.source("--phantom=sphere:16").sha256());
    assertNotEquals(sphere, Given.source("--phantom=sphere:17").sha256());
    String before = labels().sha256();
    Files.writeString(
        folder.resolve("l.nrrd"), Files.readString(folder.resolve("l.nrrd")).replace('7', '8'));
    assertNotEquals(before, Given.source("--volume", folder.resolve("l.nrrd").toString()).sha256());
  }

  @Test
  void optionsOfAReaderReachIt() throws IOException {
    Path raw = Files.write(folder.resolve("v.raw"), new byte[] {0, 1, 1, 0, 2, 0, 0, 0});
    VolumeSource source = Given.source("--volume=" + raw, "--raw=2x2x1:u16be:1,2,3");
    assertEquals(2, source.header().grid().sizeX());
    assertEquals("(1.0, 2.0, 3.0)", source.header().grid().spacingMm().toString());
    assertEquals(List.of(raw), source.files());
    assertEquals(256, source.greyValues().value(1, 0, 0));
    assertEquals(512, source.greyValues().value(0, 1, 0));
    VolumeFormatException refusal =
        assertThrows(
            VolumeFormatException.class, () -> Given.source("--volume=" + raw, "--raw=2x2:u8:1"));
    assertTrue(refusal.getMessage().contains("--raw 2x2:u8:1"), refusal.getMessage());
  }

  @Test
  void bodiesOfASceneStandWhereItSays() throws IOException {
    labels();
    Path scene = folder.resolve("s.json");
    Files.writeString(
        scene,
        """
        { "bodies": [ { "name": "one", "volume": "l.nrrd", "segment": "label:1" },
                      { "name": "seven", "volume": "l.nrrd", "segment": "label:7",
                        "mobility": "movable", "pose": { "translation_mm": [0, 5, 0] } } ] }
        """);
    VolumeSource source = Given.source("--scene=" + scene);
    assertEquals("scene " + scene, source.name());
    assertEquals(List.of("one 3", "seven 2"), counts(Given.segments(source)));
    assertEquals(Mobility.MOVABLE, source.placements().get(1).mobility());
    assertEquals(5, source.placements().get(1).pose().translation.y);
    assertTrue(source.files().contains(folder.resolve("l.nrrd")), source.files().toString());
  }
}
