move(400,0,0) ' (expect alarm LB0019 column 1 says position outside the machine)
