pulse(1) ' (expect alarm LB0017 says PULSE takes 2)
