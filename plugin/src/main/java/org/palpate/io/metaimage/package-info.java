/**
 * Reads MetaImage files (.mha, .mhd).
 *
 * <p>Uses {@code io.format}, {@code io.volume} and {@code io.file}. An instance is for one thread.
 * World axes are LPS, in millimetres.
 */
package org.palpate.io.metaimage;
