//! Parameters of algorithms: numbers that are checked once.

/// What every parameter has beside its constructor `new`, which returns a
/// [`ReconstructError`](crate::ReconstructError): the number, and conversions from and to it.
macro_rules! parameter {
    ($name:ident) => {
        impl $name {
            /// The number.
            #[must_use]
            pub fn get(self) -> f64 {
                self.0
            }
        }

        #[doc = concat!("[`", stringify!($name), "::new`].")]
        impl TryFrom<f64> for $name {
            type Error = crate::ReconstructError;

            fn try_from(number: f64) -> Result<Self, Self::Error> {
                Self::new(number)
            }
        }

        impl From<$name> for f64 {
            fn from(parameter: $name) -> Self {
                parameter.0
            }
        }

        impl std::fmt::Display for $name {
            fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
                self.0.fmt(f)
            }
        }
    };
}

pub(crate) use parameter;
