arc(1,2,3) ' (expect alarm LB0017 at arc)
