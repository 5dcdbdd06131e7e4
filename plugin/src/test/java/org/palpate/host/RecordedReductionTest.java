package org.palpate.host;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.OutputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.palpate.body.BodyEvent;
import org.palpate.body.BodyScene;
import org.palpate.body.Mobility;
import org.palpate.body.Placement;
import org.palpate.collision.CollisionDevice;
import org.palpate.device.DeviceDecorator;
import org.palpate.device.DeviceState;
import org.palpate.device.GuidedHand;
import org.palpate.device.HapticDevice;
import org.palpate.device.ReadStatus;
import org.palpate.device.SimulatedDevice;
import org.palpate.device.Tremor;
import org.palpate.edit.EditSchedule;
import org.palpate.edit.HistoryEdit;
import org.palpate.frame.FrameSettings;
import org.palpate.frame.ToolFrame;
import org.palpate.frame.ToolFramePublisher;
import org.palpate.geometry.Pose;
import org.palpate.io.file.NumberText;
import org.palpate.io.table.BodyPose;
import org.palpate.io.table.CsvWriter;
import org.palpate.io.table.PosesCsv;
import org.palpate.recording.RecordingDevice;
import org.palpate.recording.SampleRecorder;
import org.palpate.recording.TrajectoryWriter;
import org.palpate.reduction.ReductionPlan;
import org.palpate.rigid.Clearance;
import org.palpate.rigid.MovableShapes;
import org.palpate.rigid.RigidCoupling;
import org.palpate.rigid.tool.RigidTool;
import org.palpate.rigid.tool.ToolSampler;
import org.palpate.testing.Seeds;
import org.palpate.volume.SegmentedVolume;
import org.palpate.volume.fracture.Fragments;
import org.palpate.volume.phantom.FracturePhantom;

/** A recorded session in which a hand moves bodies is replayed to the same bits. */
class RecordedReductionTest {
  private static final long MS = 1_000_000;
  private static final double NEWTON_PER_MM = 0.5;

  @TempDir private Path folder;

  private final FracturePhantom phantom = FracturePhantom.parse("fracture:96:3:1:1");
  private final Fragments fragments = phantom.fragments();
  private final SplittableRandom random = new SplittableRandom(Seeds.seed());
  private final Map<BodyEvent, Integer> events = new EnumMap<>(BodyEvent.class);

  /** The poses of what the hand moves and of all bodies, after each sample. */
  private final List<List<Pose>> live = new ArrayList<>();

  private ToolScene scene() {
    List<Placement> placements = new ArrayList<>();
    for (Pose pose : phantom.startPoses(fragments)) {
      placements.add(new Placement(placements.isEmpty() ? Mobility.FIXED : Mobility.MOVABLE, pose));
    }
    SegmentedVolume volume = fragments.segments();
    ContactScene contact =
        new ContactScene(volume, placements, ContactSettings.standard(), Optional.empty());
    BodyScene bodies = contact.newBodies();
    RigidTool point = ToolSampler.point();
    return new ToolScene(
        contact,
        bodies,
        point,
        MovableShapes.ofPoints(bodies),
        Collections.nCopies(bodies.count(), Clearance.POINTS),
        OptionalDouble.empty(),
        CollisionDevice.CPU);
  }

  /** A device that has no new sample now and then. */
  private final class Slow extends DeviceDecorator {
    private Slow(HapticDevice device) {
      super(device);
    }

    @Override
    public ReadStatus read(DeviceState state) {
      return random.nextInt(20) == 0 ? ReadStatus.REPEATED : device.read(state);
    }
  }

  @Test
  void theReplayOfAReductionWithUndoHasItsBits() throws IOException {
    record(folder.resolve("t.csv"), folder.resolve("t.poses.csv"));
    assertTrue(events.get(BodyEvent.TAKEN) >= 2, events.toString());
    assertEquals(events.get(BodyEvent.TAKEN), events.get(BodyEvent.RELEASED));
    assertTrue(events.get(BodyEvent.HELD) > 1000, events.toString());
    assertTrue(events.get(BodyEvent.PLACED) >= 3, events.toString());
    ToolScene scene = scene();
    List<String> names =
        scene.contactScene().volume().segments().stream().map(segment -> segment.name()).toList();
    List<BodyPose> poses = PosesCsv.read(folder.resolve("t.poses.csv"), names);
    ToolReplay replay =
        new ToolReplay(
            scene,
            TrajectoryFile.read(folder.resolve("t.csv"), true),
            false,
            EditSchedule.NONE,
            poses,
            Optional.empty());
    replay.run(
        (number, frame) -> {
          List<Pose> replayed = poses(frame, scene.bodies());
          for (int n = 0; n < replayed.size(); n++) {
            assertTrue(
                replayed.get(n).sameBits(live.get(number).get(n)),
                "seed " + Seeds.seed() + ", sample " + number + ", pose " + n);
          }
        });
  }

  private static List<Pose> poses(ToolFrame frame, BodyScene bodies) {
    List<Pose> poses = new ArrayList<>(List.of(new Pose().set(frame.motion().pose())));
    for (int n = 0; n < bodies.count(); n++) {
      poses.add(new Pose().set(bodies.body(n).pose()));
    }
    return poses;
  }

  private void record(Path samplesFile, Path posesFile) throws IOException {
    ToolScene scene = scene();
    List<Pose> truth = Collections.nCopies(scene.bodies().count(), new Pose());
    GuidedHand hand =
        new GuidedHand(
            ReductionPlan.of(
                    scene.contactScene().newBodies(), truth, scene.movableShapes(), scene.bodies())
                .stops(),
            Tremor.ofHand(1),
            100,
            MS);
    RigidCoupling coupling = scene.coupling(NEWTON_PER_MM);
    FrameSettings settings = scene.liveFrame(hand.specification(), NEWTON_PER_MM);
    warmUp(scene, settings, coupling);
    SampleRecorder recorder = new SampleRecorder();
    ToolFrame frame =
        scene.newFrame(
            new RecordingDevice(new Slow(hand), recorder),
            settings,
            coupling,
            ToolFramePublisher.NONE);
    StringBuilder samples = new StringBuilder();
    TrajectoryWriter writer = new TrajectoryWriter(samples, NumberText::text);
    try (OutputStream stream = Files.newOutputStream(posesFile)) {
      CsvWriter rows = PosesCsv.writer(stream);
      frame.listen(
          (body, event, pose, inHand) -> {
            events.merge(event, 1, Integer::sum);
            add(rows, frame.sampleOfChanges(), "fragment" + (body + 1), event, pose, inHand);
          });
      int sinceRelease = 200;
      long frames = Math.round(1000 * hand.durationSeconds() * 1.06);
      for (long n = 0; n < frames; n++) {
        sinceRelease = frame.heldBody() < 0 ? sinceRelease + 1 : 0;
        if (sinceRelease <= 120 && sinceRelease % 30 == 0 && sinceRelease > 0) {
          boolean undoes = sinceRelease % 60 == 30;
          scene.edits().offer(undoes ? HistoryEdit.undo() : HistoryEdit.redo());
        }
        frame.run(n * MS);
        if (recorder.drainTo(writer) > 0) {
          live.add(poses(frame, scene.bodies()));
        }
      }
    }
    Files.writeString(samplesFile, samples, StandardCharsets.UTF_8);
  }

  private static void add(
      CsvWriter rows, long sample, String body, BodyEvent event, Pose pose, Pose inHand) {
    try {
      PosesCsv.add(rows, sample, body, event, pose, inHand);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  /** A session warms the same solver up with another hand. */
  private static void warmUp(ToolScene scene, FrameSettings settings, RigidCoupling coupling) {
    HapticDevice other = SimulatedDevice.withOrientation(7, scene.handTarget(), MS);
    ToolFrame frame = scene.newWarmUpFrame(other, settings, coupling);
    for (int n = 0; n < 3000; n++) {
      frame.run(n * MS);
    }
  }
}
