home()
home(1) ' (expect alarm LB0017 at home)
