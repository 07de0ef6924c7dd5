//! Picture files, and input that fringes cannot be read from.

use std::io::Cursor;

use image::{DynamicImage, ImageFormat};
use stickslip_hybrid::fringe::{
    Carrier, Depth, Exposure, Format, FourierOptions, Frame, FringeError, PixelMap, Plane, decode,
    encode, four_step, fourier, measurement, orders, picture, unwrap,
};

fn small() -> Frame {
    Frame::new(128, 96, [0.0, 0.0], [1.0, -1.0]).unwrap()
}

fn straight(frame: Frame) -> PixelMap {
    PixelMap::of(frame, |place| Some(0.13 * place[0] + 0.05 * place[1])).unwrap()
}

fn rising() -> FourierOptions {
    FourierOptions::new(Carrier::Found {
        towards: [1.0, 0.0],
    })
}

#[test]
fn files_keep_every_grey_level() {
    for format in [Format::Png, Format::Tiff] {
        for depth in [Depth::Eight, Depth::Sixteen] {
            let exposure = Exposure {
                noise: 0.1,
                depth: Some(depth),
                ..Exposure::default()
            };
            let orders = straight(small())
                .restricted(|place| place[0] > 9.5)
                .unwrap();
            let shown = picture(&orders, &exposure, 1).unwrap();
            let read = decode(&encode(&shown, format, depth).unwrap()).unwrap();
            assert_eq!((read.columns, read.rows, read.depth), (128, 96, depth));
            assert!(
                shown
                    .present()
                    .all(|(pixel, value)| read.intensities[pixel] == value)
            );
            assert!(
                read.intensities
                    .iter()
                    .zip(shown.valid())
                    .all(|(&value, &valid)| valid || value == 0.0)
            );
            let placed = read.placed([0.0, 0.0], [1.0, -1.0], Some(0.0)).unwrap();
            let missing =
                (0..placed.frame().pixels()).filter(|&pixel| placed.frame().place(pixel)[0] < 9.5);
            assert!(
                missing.clone().count() == 960
                    && missing.into_iter().all(|pixel| placed.get(pixel).is_none())
            );
        }
    }
}

#[test]
fn transparency_is_a_mask_and_colour_is_refused() {
    let file = |image: DynamicImage| {
        let mut bytes = Cursor::new(Vec::new());
        image.write_to(&mut bytes, ImageFormat::Png).unwrap();
        bytes.into_inner()
    };
    let mut grey = image::GrayAlphaImage::from_pixel(3, 2, image::LumaA([51, 255]));
    grey.put_pixel(1, 0, image::LumaA([51, 0]));
    let read = decode(&file(grey.into())).unwrap();
    assert_eq!(read.opaque, [true, false, true, true, true, true]);
    assert!(read.intensities.iter().all(|&value| value == 0.2));
    assert!(
        read.placed([0.0, 0.0], [1.0, 1.0], None)
            .unwrap()
            .get(1)
            .is_none()
    );
    let colour = decode(&file(image::RgbImage::new(2, 2).into())).unwrap_err();
    assert!(matches!(colour, FringeError::Colour(_)) && colour.to_string().contains("grey"));
    for bytes in [
        &b""[..],
        &b"no picture"[..],
        &file(image::GrayImage::new(4, 4).into())[..30],
    ] {
        assert!(matches!(decode(bytes), Err(FringeError::File(_))));
    }
}

/// Without fringes, with noise alone, with fringes that close on themselves.
#[test]
fn pictures_without_carrier_are_refused() {
    let flat = PixelMap::of(small(), |_| Some(0.5)).unwrap();
    let none = |picture: &PixelMap| match fourier(picture, &rising()) {
        Err(FringeError::NoCarrier { strength, least }) => (strength, least),
        other => panic!("{other:?}"),
    };
    assert_eq!(none(&flat).0, 0.0);
    for seed in 0..20 {
        // Half an order of error in either direction wipes all fringes out.
        let noise = picture(
            &straight(small()),
            &Exposure {
                order_error: 0.5,
                ..Exposure::default()
            },
            seed,
        )
        .unwrap();
        let (strength, least) = none(&noise);
        assert!(strength > 1.0 && strength < least && least < 30.0);
    }
    let large = Frame::new(256, 256, [-127.5, 127.5], [1.0, -1.0]).unwrap();
    let rings = PixelMap::of(large, |place| {
        Some(1.2e-3 * (place[0].powi(2) + place[1].powi(2)))
    })
    .unwrap();
    let refused = fourier(
        &picture(&rings, &Exposure::default(), 1).unwrap(),
        &rising(),
    )
    .unwrap_err();
    assert!(
        matches!(refused, FringeError::Crowded { share, .. } if share < 0.5),
        "{refused}"
    );
    assert!(refused.to_string().contains("add carrier fringes"));
    // A carrier steeper than the rings opens them.
    let opened = Plane {
        gradient: [0.2, 0.0],
        constant: 0.0,
    };
    let orders = orders(large, 1.0, &opened, |place| {
        Some(3e-4 * (place[0].powi(2) + place[1].powi(2)))
    })
    .unwrap();
    assert!(
        fourier(
            &picture(&orders, &Exposure::default(), 1).unwrap(),
            &rising()
        )
        .is_ok()
    );
}

#[test]
fn carriers_that_pixels_cannot_show() {
    let shown = picture(&straight(small()), &Exposure::default(), 1).unwrap();
    for gradient in [[0.6, 0.0], [0.01, 0.0], [0.0, -0.5]] {
        let refused = fourier(&shown, &FourierOptions::new(Carrier::Given(gradient)));
        assert!(matches!(refused, Err(FringeError::CarrierRange { .. })));
    }
    let elsewhere = fourier(&shown, &FourierOptions::new(Carrier::Given([-0.1, 0.2])));
    assert!(
        matches!(
            elsewhere,
            Err(FringeError::NoCarrier { .. } | FringeError::Crowded { .. })
        ),
        "{elsewhere:?}"
    );
    // So near to the Nyquist frequency that the band has no width, a refusal and no endless margin.
    assert!(
        fourier(
            &shown,
            &FourierOptions::new(Carrier::Given([0.4999999, 0.0]))
        )
        .is_err()
    );
    let steep = PixelMap::of(small(), |place| Some(0.4999999 * place[0])).unwrap();
    let steep = picture(&steep, &Exposure::default(), 1).unwrap();
    assert!(
        fourier(
            &steep,
            &FourierOptions {
                least_share: 0.0,
                ..FourierOptions::new(Carrier::Given([0.4999999, 0.0]))
            }
        )
        .is_err()
    );
    let tiny = PixelMap::of(Frame::new(2, 1, [0.0, 0.0], [1.0, 1.0]).unwrap(), |place| {
        Some(place[0])
    })
    .unwrap();
    assert!(matches!(
        fourier(&tiny, &rising()),
        Err(FringeError::NoCarrier { .. })
    ));
    for (band, least_share, settled, towards) in [
        (0.0, 0.5, 1e-3, 1.0),
        (1.0, 0.5, 1e-3, 1.0),
        (0.7, 1.5, 1e-3, 1.0),
        (0.7, 0.5, f64::NAN, 1.0),
        (0.7, 0.5, 1e-3, 0.0),
    ] {
        let options = FourierOptions {
            carrier: Carrier::Found {
                towards: [towards, 0.0],
            },
            band,
            least_share,
            passes: 1,
            settled,
        };
        assert!(matches!(
            fourier(&shown, &options),
            Err(FringeError::Parameter { .. })
        ));
    }
}

#[test]
fn maps_without_sense() {
    let frame = Frame::new(2, 2, [0.0, 0.0], [1.0, 1.0]).unwrap();
    for (columns, rows, step) in [
        (0, 2, 1.0),
        (2, 0, 1.0),
        (2, 2, 0.0),
        (2, 2, f64::NAN),
        (usize::MAX, 3, 1.0),
        (1 << 15, 1 << 14, 1.0),
    ] {
        assert!(matches!(
            Frame::new(columns, rows, [0.0, 0.0], [step, 1.0]),
            Err(FringeError::Frame { .. })
        ));
    }
    for pixel in [0.0, -1.0, f64::NAN, 3.0] {
        assert!(Frame::over([[0.0, 0.0], [2.0, 2.0]], pixel).is_err());
    }
    assert_eq!(
        PixelMap::new(frame, vec![1.0; 3], vec![true; 4]).unwrap_err(),
        FringeError::Size {
            columns: 2,
            rows: 2,
            found: 3
        }
    );
    assert_eq!(
        PixelMap::new(frame, vec![1.0; 4], vec![false; 4]).unwrap_err(),
        FringeError::Masked { pixels: 4 }
    );
    let spoilt = PixelMap::new(frame, vec![1.0, 1.0, f64::NAN, 1.0], vec![true; 4]).unwrap_err();
    assert!(
        matches!(
            spoilt,
            FringeError::NotFinite {
                column: 0,
                row: 1,
                ..
            }
        ),
        "{spoilt}"
    );
    assert!(matches!(
        PixelMap::with_gaps(frame, vec![f64::INFINITY; 4]),
        Err(FringeError::NotFinite { .. })
    ));
    assert!(matches!(
        orders(frame, f64::NAN, &Plane::default(), |_| Some(0.0)),
        Err(FringeError::Parameter { .. })
    ));
    assert!(matches!(
        orders(frame, 1.0, &Plane::default(), |_| Some(f64::NAN)),
        Err(FringeError::NotFinite { .. })
    ));
    assert!(matches!(
        orders(frame, 1.0, &Plane::default(), |_| None),
        Err(FringeError::Masked { pixels: 4 })
    ));
}

#[test]
fn exposures_out_of_range() {
    let orders = straight(small());
    let fair = Exposure::default;
    let cases = [
        Exposure {
            background: 0.0,
            ..fair()
        },
        Exposure {
            modulation: 0.6,
            ..fair()
        },
        Exposure {
            modulation: 0.0,
            ..fair()
        },
        Exposure {
            order_error: -0.1,
            ..fair()
        },
        Exposure {
            noise: f64::NAN,
            ..fair()
        },
        Exposure {
            speckle_patterns: Some(0),
            ..fair()
        },
    ];
    for exposure in cases {
        assert!(
            matches!(
                picture(&orders, &exposure, 1),
                Err(FringeError::Parameter { .. })
            ),
            "{exposure:?}"
        );
    }
}

#[test]
fn pictures_that_do_not_belong_together() {
    let (first, shifted) = (
        straight(small()),
        straight(Frame::new(128, 96, [0.5, 0.0], [1.0, -1.0]).unwrap()),
    );
    let mixed = [first.clone(), first.clone(), shifted.clone(), first.clone()];
    assert!(matches!(
        four_step(&mixed, 0.0),
        Err(FringeError::Frames(_))
    ));
    assert!(matches!(
        measurement([Some(&first), Some(&shifted)], 1.0, [0.1; 2], 1),
        Err(FringeError::Frames(_))
    ));
    let same = [(); 4].map(|()| first.clone());
    assert_eq!(
        four_step(&same, 0.0).unwrap_err(),
        FringeError::Modulation {
            greatest: 0.0,
            least: 0.0
        }
    );
    assert!(matches!(
        four_step(&same, f64::NAN),
        Err(FringeError::Parameter { .. })
    ));
    assert!(matches!(
        measurement([None, None], 1.0, [0.1; 2], 1),
        Err(FringeError::Masked { pixels: 0 })
    ));
    assert!(matches!(
        measurement([Some(&first), None], 1.0, [0.1; 2], 0),
        Err(FringeError::Parameter { .. })
    ));
    assert!(matches!(
        measurement([Some(&first), None], 1.0, [-0.1; 2], 1),
        Err(FringeError::Parameter { .. })
    ));
    let odd = first.restricted(|place| place[0] % 2.0 == 1.0).unwrap();
    assert!(matches!(
        measurement([Some(&odd), None], 1.0, [0.1; 2], 2),
        Err(FringeError::Masked { .. })
    ));
    assert!(matches!(
        unwrap(&first, &[1.0; 3]),
        Err(FringeError::Size { found: 3, .. })
    ));
    assert!(matches!(
        unwrap(&first, &vec![f64::NAN; 128 * 96]),
        Err(FringeError::NotFinite { .. })
    ));
}
