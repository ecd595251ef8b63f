x=mod(5,0) ' (expect alarm LB0016 at mod)
