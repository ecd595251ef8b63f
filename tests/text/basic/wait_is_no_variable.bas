input wait ' (expect alarm LB0005 at wait)
