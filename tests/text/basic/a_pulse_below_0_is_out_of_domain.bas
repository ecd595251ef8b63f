pulse(-1,2) ' (expect alarm LB0018 says the times of a pulse are 0 ms or more)
