air(2) ' (expect alarm LB0018 says AIR is 0, off, or 1, on)
