x=log(0) ' (expect alarm LB0018 at log)
