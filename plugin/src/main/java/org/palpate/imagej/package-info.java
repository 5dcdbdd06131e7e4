/**
 * The ImageJ and Fiji plug-in, an implementation of {@code host}.
 *
 * <p>Uses {@code host} and {@code io}; besides {@code io} the only package that imports ImageJ's
 * API.
 */
package org.palpate.imagej;
