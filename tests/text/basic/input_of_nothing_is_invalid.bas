input a ' (expect alarm LB0025 at input)
