package org.palpate.host;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.Test;
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
  private final ElasticBody body = body();
  private final TouchProperties properties = new TouchProperties(new Accumulator());
  private final PublishedShape shape = body.publish(properties.accumulator());
  private final SceneModel model = new SceneModel(WorldAxes.UNKNOWN, Theme.DARK);
  private final SceneSynchronizer sync =
      new SceneSynchronizer(
          properties, scene.grid(), model, List::of, Optional::empty, Optional.of(shape));
  private final SynchronousUpdates updates = new SynchronousUpdates(body);
  private long now;

  private ElasticBody body() {
    List<Segment> segments = scene.volume().segments();
    ElasticSegment soft =
        new ElasticSegment(segments.get(0).bits(), new ElasticMaterial(10e3, 0.4));
    return new ElasticBody(
        new ControlLattice(scene.metric(), List.of(soft), List.of(segments.get(1).bits()), 4),
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

  @Test
  void thePointIsDrawnWhereTheDeformedSurfaceIs() {
    PointFrame frame = frame();
    double deepest = 0;
    for (int tick = 0; tick < 200; tick++) {
      run(frame, 33);
      sync.run();
      Vec3 expected = scene.grid().gridToWorld(frame.presentPosition(), new Vec3());
      Vec3 drawn = model.state().marks().orElseThrow().point();
      assertTrue(drawn.sub(expected, new Vec3()).length() < 1e-9, drawn + " and " + expected);
      assertTrue(frame.point().position.sameBits(sync.pointAtRest(new Vec3())));
      double longest = model.state().deformation().map(Deformation::longestMm).orElse(0.0);
      deepest = Math.max(deepest, longest);
    }
    assertTrue(deepest > 0.5, "displaced by " + deepest + " mm");
  }

  @Test
  void aTickRequestsOneRedrawOfEverything() {
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
