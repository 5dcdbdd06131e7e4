package org.palpate.force;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.palpate.geometry.GridMetric;
import org.palpate.geometry.Vec3;
import org.palpate.proxy.InteractionPoint;
import org.palpate.testing.Floor;
import org.palpate.volume.ScalarVolume;

class GreyMaterialsTest {
  private static final GridMetric METRIC = Floor.METRIC;
  private static final double STIFFNESS = 0.5;

  private final InteractionPoint point = new InteractionPoint();
  private final Vec3 device = new Vec3();
  private final Vec3 force = new Vec3();

  /** Returns values of fat up to x = 16 and of bone beyond. */
  private static ScalarVolume fatAndBone() {
    ScalarVolume values = ScalarVolume.of(Floor.GRID, ScalarVolume.Storage.INT16);
    for (int n = 0; n < 32 * 32 * 32; n++) {
      values.set(n % 32, n / 32 % 32, n / 1024, n % 32 < 16 ? -100 : 1200);
    }
    return values;
  }

  private static GreyMaterials ct() {
    return new GreyMaterials(fatAndBone(), GreyMaterials.CT);
  }

  private void press(double x, double depth) {
    point.position.set(x, 16, Floor.TOP);
    device.set(x, 16, Floor.TOP - depth);
    point.contact = depth > 0;
  }

  @Test
  void rowsAreInterpolatedAndTheEndsStay() {
    GreyMaterials materials =
        new GreyMaterials(
            fatAndBone(),
            List.of(
                new GreyMaterials.Row(-100, 0.2, 0.1, 0),
                new GreyMaterials.Row(100, 0.6, 0.3, 0.002),
                new GreyMaterials.Row(1000, 1, 0.3, 0.001)));
    assertEquals(0.2, materials.stiffness(-5000));
    assertEquals(0.2, materials.stiffness(-100));
    assertEquals(0.4, materials.stiffness(0), 1e-15);
    assertEquals(0.2, materials.friction(0), 1e-15);
    assertEquals(0.001, materials.damping(0), 1e-15);
    assertEquals(0.6, materials.stiffness(100));
    assertEquals(0.8, materials.stiffness(550), 1e-15);
    assertEquals(1, materials.stiffness(1e9));
    assertEquals(1, materials.stiffest());
    assertTrue(materials.damps());
  }

  @Test
  void rowsMustRise() {
    GreyMaterials.Row row = new GreyMaterials.Row(5, 1, 0, 0);
    assertThrows(
        IllegalArgumentException.class, () -> new GreyMaterials(fatAndBone(), List.of(row, row)));
    assertThrows(IllegalArgumentException.class, () -> new GreyMaterials(fatAndBone(), List.of()));
  }

  @Test
  void boneIsHarderThanFat() {
    for (double x : new double[] {5, 27}) {
      ContactForce contact = new ContactForce(METRIC, ForceSettings.of(STIFFNESS, 0.2));
      contact.use(ct());
      press(x, 2);
      contact.compute(point, device, force);
      assertEquals(STIFFNESS * 2 * (x < 16 ? 0.15 : 1), force.z, 1e-12);
    }
  }

  @Test
  void theValueUnderTheContactCountsAndNotThatOfTheDevice() {
    ScalarVolume values = ScalarVolume.of(Floor.GRID, ScalarVolume.Storage.INT16);
    for (int n = 0; n < 32 * 32 * 32; n++) {
      values.set(n % 32, n / 32 % 32, n / 1024, n / 1024 < 4 ? 1200 : -100);
    }
    ContactForce contact = new ContactForce(METRIC, ForceSettings.of(STIFFNESS, 0.2));
    contact.use(new GreyMaterials(values, GreyMaterials.CT));
    press(16, 7); // The device is deep in bone, under four voxels of fat.
    contact.compute(point, device, force);
    assertEquals(STIFFNESS * 7 * 0.15, force.z, 1e-12);
  }

  @Test
  void aHandThatSlidesFromFatToBoneFeelsNoStep() {
    double depthMm = 3;
    for (double stepMm : new double[] {0.005, 0.05, 0.4}) {
      ContactForce contact = new ContactForce(METRIC, ForceSettings.of(STIFFNESS, 0));
      contact.use(ct());
      press(13, depthMm);
      contact.compute(point, device, force);
      Vec3 last = new Vec3().set(force);
      for (double x = 13; x < 24; x += stepMm) {
        press(x, depthMm);
        contact.compute(point, device, force);
        double change = force.sub(last, new Vec3()).length();
        double most = 1.5 * STIFFNESS * Math.max(stepMm, ChangeBound.MIN_MOTION_EDGES);
        assertTrue(change <= most, "at " + x + " the force changed by " + change);
        last.set(force);
      }
      for (int n = 0; n < 1000; n++) {
        contact.compute(point, device, force);
      }
      assertEquals(STIFFNESS * depthMm, force.z, 1e-5);
    }
  }

  @Test
  void settingsThatAreRetunedScaleAllMaterials() {
    ContactForce contact = new ContactForce(METRIC, ForceSettings.of(STIFFNESS, 0.2));
    contact.use(ct());
    contact.change(ForceSettings.of(2 * STIFFNESS, 0.2));
    press(5, 2);
    contact.compute(point, device, force);
    assertEquals(2 * STIFFNESS * 2 * 0.15, force.z, 1e-12);
  }

  @Test
  void aPointWithMassFeelsTheSameStiffness() {
    for (double x : new double[] {5, 27}) {
      MassSettings held = new MassSettings(0.05, new Vec3());
      MassiveContact body = new MassiveContact(METRIC, ForceSettings.of(STIFFNESS, 0.2), held);
      body.use(ct());
      Vec3 target = new Vec3();
      point.position.set(x, 16, Floor.TOP + 1);
      body.place(point.position);
      device.set(x, 16, Floor.TOP - 2);
      for (int n = 0; n < 6000; n++) {
        body.move(point, device, 1_000_000, target);
        point.position.set(target.x, target.y, Math.max(Floor.TOP, target.z));
        point.contact = target.z < Floor.TOP;
        body.compute(point, force);
      }
      assertEquals(STIFFNESS * 2 * (x < 16 ? 0.15 : 1), force.z, 0.02);
    }
  }

  /** The values grow by 2, 30 and 500 a voxel, so that each coordinate can be read from a value. */
  @Test
  void theValueUnderThePointIsTakenAnEdgeBelowTheSurfaceTowardsTheDevice() {
    ScalarVolume values = ScalarVolume.of(Floor.GRID, ScalarVolume.Storage.FLOAT32);
    for (int n = 0; n < 32 * 32 * 32; n++) {
      values.set(
          n % 32, n / 32 % 32, n / 1024, 2 * (n % 32) + 30 * (n / 32 % 32) + 500 * (n / 1024));
    }
    GreyMaterials materials = new GreyMaterials(values, GreyMaterials.CT);
    GridMetric metric = new GridMetric(1, 0.5, 2);
    InteractionPoint at = new InteractionPoint();
    at.position.set(16, 15, 14);
    at.surfaceHeightMm = 0.7;
    for (Vec3 device :
        List.of(
            new Vec3(20, 15, 14),
            new Vec3(16, 3, 14),
            new Vec3(16, 15, 9),
            new Vec3(12, 18, 15),
            new Vec3(16.2, 15.3, 14.1))) {
      double x = device.x - 16;
      double y = (device.y - 15) * 0.5;
      double z = (device.z - 14) * 2;
      double distance = Math.sqrt(x * x + y * y + z * z);
      double part = Math.min(1, 1.2 / distance); // the height, and the shortest edge of 0.5 mm
      double expected =
          2 * (16 + part * (device.x - 16) - 0.5)
              + 30 * (15 + part * (device.y - 15) - 0.5)
              + 500 * (14 + part * (device.z - 14) - 0.5);
      assertEquals(expected, materials.greyUnder(at, device, metric), 1e-3, device.toString());
    }
    at.surfaceHeightMm = -3;
    assertEquals(
        2 * 16 + 30 * 14.5 + 500 * 13.5,
        materials.greyUnder(at, new Vec3(24, 15, 14), metric),
        1e-3,
        "a surface below the point does not count");
  }

  @Test
  void onlyRowsWithDampingDamp() {
    ScalarVolume values = fatAndBone();
    List<GreyMaterials.Row> plain =
        List.of(new GreyMaterials.Row(0, 0.2, 0.1, 0), new GreyMaterials.Row(9, 0.6, 0.3, 0));
    assertFalse(new GreyMaterials(values, plain).damps());
    List<GreyMaterials.Row> damped =
        List.of(new GreyMaterials.Row(0, 0.2, 0.1, 1e-3), new GreyMaterials.Row(9, 0.6, 0.3, 0));
    assertTrue(new GreyMaterials(values, damped).damps());
  }
}
