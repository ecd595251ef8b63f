x=xpos()
x=xpos(1) ' (expect alarm LB0017 at xpos)
