/**
 * What a volume platform gives and gets: volume and segments in, properties and edits out,
 * lifecycle. World to grid and back happens here alone.
 *
 * <p>Uses {@code interaction}, {@code scene}, {@code device}, {@code volume}.
 */
package org.palpate.host;
