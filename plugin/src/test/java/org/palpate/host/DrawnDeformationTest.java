package org.palpate.host;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.palpate.device.DeviceSpecification;
import org.palpate.device.SimulatedDevice;
import org.palpate.elastic.ElasticBody;
import org.palpate.elastic.PublishedShape;
import org.palpate.elastic.SynchronousUpdates;
import org.palpate.elastic.lattice.ControlLattice;
import org.palpate.elastic.lattice.ElasticMaterial;
import org.palpate.elastic.lattice.ElasticSegment;
import org.palpate.frame.GridDevice;
import org.palpate.frame.PointFrame;
import org.palpate.geometry.Vec3;
import org.palpate.scene.Deformation;
import org.palpate.scene.SceneModel;
import org.palpate.scene.SceneSynchronizer;
import org.palpate.scene.Theme;
import org.palpate.scene.WorldAxes;
import org.palpate.sync.Accumulator;
import org.palpate.sync.TouchProperties;
import org.palpate.volume.Segment;
import org.palpate.volume.phantom.Phantom;

/** The way of an elastic shape from frames to the drawn scene. */
class DrawnDeformationTest {
  private static final long PERIOD_NANOS = 1_000_000;
  private static final DeviceSpecification DEVICE =
      new DeviceSpecification("test", "", 3, 0.8, 80, PERIOD_NANOS);

  private final ContactScene scene =
      new ContactScene(
          Phantom.parse("block:32").segments(), ContactSettings.standard(SolverKind.SMOOTH));
  private final TouchProperties properties = new TouchProperties(new Accumulator());
  private final SceneModel model = new SceneModel(WorldAxes.UNKNOWN, Theme.DARK);
  private ElasticBody body;
  private PublishedShape shape;
  private SceneSynchronizer sync;
  private SynchronousUpdates updates;
  private long now;

  private void open(OptionalDouble contactRadiusMm) {
    body = body(contactRadiusMm);
    shape = body.publish(properties.accumulator());
    sync =
        new SceneSynchronizer(
            properties, scene.grid(), model, List::of, Optional::empty, Optional.of(shape));
    updates = new SynchronousUpdates(body);
  }

  private ElasticBody body(OptionalDouble contactRadiusMm) {
    List<Segment> segments = scene.volume().segments();
    ElasticSegment soft =
        new ElasticSegment(segments.get(0).bits(), new ElasticMaterial(10e3, 0.4));
    return new ElasticBody(
        new ControlLattice(
            scene.metric(), List.of(soft), List.of(segments.get(1).bits()), 4, contactRadiusMm),
        scene.metric());
  }

  private PointFrame frame() {
    PointFrame made =
        scene.newFrame(
            GridDevice.fromWorld(
                new SimulatedDevice(3, scene.handTarget(), PERIOD_NANOS), scene.grid()),
            scene.liveFrame(DEVICE, 0.4),
            (device, point, newton, contact, number) -> {
              shape.setFrame();
              properties.publish(device, point, newton, contact, number);
            });
    made.deform(body.contact());
    return made;
  }

  private void run(PointFrame frame, int frames) {
    for (int n = 0; n < frames; n++) {
      updates.beforeFrame();
      now += PERIOD_NANOS;
      frame.run(now);
    }
  }

  @ParameterizedTest
  @ValueSource(booleans = {false, true})
  void thePointIsDrawnWhereTheDeformedSurfaceIs(boolean windowed) {
    open(windowed ? OptionalDouble.of(4) : OptionalDouble.empty());
    PointFrame frame = frame();
    double deepest = 0;
    int windows = 0;
    for (int tick = 0; tick < 200; tick++) {
      run(frame, 33);
      sync.run();
      Vec3 expected = scene.grid().gridToWorld(frame.presentPosition(), new Vec3());
      Vec3 drawn = model.state().marks().orElseThrow().point();
      assertTrue(drawn.sub(expected, new Vec3()).length() < 1e-9, drawn + " and " + expected);
      assertTrue(frame.point().position.sameBits(sync.pointAtRest(new Vec3())));
      double longest = model.state().deformation().map(Deformation::longestMm).orElse(0.0);
      deepest = Math.max(deepest, longest);
      Optional<Deformation> deformation = model.state().deformation();
      deformation.ifPresent(this::assertMovesAsTheShape);
      windows += deformation.flatMap(Deformation::window).isPresent() ? 1 : 0;
    }
    assertEquals(windowed, windows > 0);
    assertTrue(deepest > 0.5, "displaced by " + deepest + " mm");
  }

  /** Each node that is drawn, those of the window if there is one, is where the shape has it. */
  private void assertMovesAsTheShape(Deformation drawn) {
    Deformation nodes = drawn.window().orElse(drawn);
    Vec3 spacing =
        new Vec3(scene.metric().spacingX(), scene.metric().spacingY(), scene.metric().spacingZ());
    for (int node = 0; node < nodes.displacementsMm().length / 3; node++) {
      int[] index = {
        node % nodes.nodes(0),
        node / nodes.nodes(0) % nodes.nodes(1),
        node / nodes.nodes(0) / nodes.nodes(1)
      };
      Vec3 rest = new Vec3();
      for (int axis = 0; axis < 3; axis++) {
        double mm = nodes.originMm().get(axis) + index[axis] * nodes.cellMm().get(axis);
        rest.set(axis, mm / spacing.get(axis));
      }
      Vec3 present = shape.present(rest, new Vec3());
      for (int axis = 0; axis < 3; axis++) {
        double moved = (present.get(axis) - rest.get(axis)) * spacing.get(axis);
        assertEquals(nodes.displacementsMm()[3 * node + axis], moved, 1e-5, "node " + node);
      }
    }
  }

  @Test
  void aTickRequestsOneRedrawOfEverything() {
    open(OptionalDouble.empty());
    PointFrame frame = frame();
    AtomicInteger redraws = new AtomicInteger();
    model.onChange(redraws::incrementAndGet);
    long revision = model.state().staticRevision();
    for (int tick = 1; tick <= 100; tick++) {
      run(frame, 33);
      sync.run();
      assertEquals(tick, redraws.get());
    }
    assertTrue(model.state().staticRevision() > revision + 20, "the surfaces are drawn anew");
  }
}
