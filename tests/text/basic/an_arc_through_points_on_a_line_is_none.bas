move(0,0)
arc(1,0,0,2,0,0) ' (expect alarm LB0024 at arc)
