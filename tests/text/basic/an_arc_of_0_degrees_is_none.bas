arc(0,0,5,30,30) ' (expect alarm LB0024 at arc)
