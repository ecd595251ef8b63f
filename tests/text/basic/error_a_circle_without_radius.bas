circle(0,0,0) ' (expect alarm LB0024 column 1 says degenerate arc)
