wait(-0.001) ' (expect alarm LB0018)
