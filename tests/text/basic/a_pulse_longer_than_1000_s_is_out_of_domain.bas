pulse(1e6,1) ' (expect alarm LB0018 says 0.000001 to 1000000 ms)
