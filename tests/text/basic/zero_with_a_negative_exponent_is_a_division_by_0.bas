x=0^-1 ' (expect alarm LB0016 at ^)
