arc(10,0,4,1) ' (expect alarm LB0024 at arc)
