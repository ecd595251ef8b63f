burn(1,2) ' (expect alarm LB0017 says BURN takes 1)
