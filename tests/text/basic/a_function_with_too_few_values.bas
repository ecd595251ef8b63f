x=atan2(1) ' (expect alarm LB0017 at atan2)
