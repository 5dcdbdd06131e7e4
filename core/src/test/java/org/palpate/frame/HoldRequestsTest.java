package org.palpate.frame;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;
import org.palpate.device.DeviceState;
import org.palpate.frame.HoldRequests.Request;

/** Presses the button that takes hold, and requests the same by calls. */
class HoldRequestsTest {
  private static final int OTHER_BUTTONS = ~DeviceState.FIRST_BUTTON;

  private final HoldRequests requests = new HoldRequests();

  @Test
  void aButtonMakesARequestOnlyWhenItIsPressedOrReleased() {
    requests.takeButton(OTHER_BUTTONS);
    assertEquals(Request.NONE, requests.take());
    requests.takeButton(DeviceState.FIRST_BUTTON);
    assertEquals(Request.TAKE, requests.take());
    requests.takeButton(DeviceState.FIRST_BUTTON | OTHER_BUTTONS);
    assertEquals(Request.NONE, requests.take());
    requests.takeButton(OTHER_BUTTONS);
    assertEquals(Request.LET_GO, requests.take());
    requests.takeButton(0);
    assertEquals(Request.NONE, requests.take());
  }

  @Test
  void theNewestRequestWaitsUntilItIsTaken() {
    requests.request(Request.LET_GO);
    requests.request(Request.TAKE);
    requests.takeButton(0);
    assertEquals(Request.TAKE, requests.take());
    assertEquals(Request.NONE, requests.take());
  }
}
