//! Connects an instance's ports.

use std::collections::HashMap;

use super::elaborate::Elaboration;
use super::environment::{Environment, Mode};
use super::graph::{Known, SignalId};
use super::statement::target_names;
use super::syntax::{self, Direction, Expression, Item, Module};
use super::{Refusal, refuse};

impl<'a> Elaboration<'a> {
    /// The signal of a port inside the instance.
    pub fn port(
        &self,
        instance: usize,
        module: &'a Module,
        name: &str,
    ) -> Result<(SignalId, Direction), Refusal> {
        let declared = module.items.iter().find_map(|item| match item {
            Item::Declaration(d) if d.name == name => d.direction,
            _ => None,
        });
        match declared {
            Some(direction) => Ok((self.own(instance, name, module.line)?, direction)),
            None => refuse(module.line, format!("the port `{name}` has no direction")),
        }
    }

    pub fn child(
        &mut self,
        parent: usize,
        instance: &'a syntax::Instance,
        depth: usize,
    ) -> Result<(), Refusal> {
        let Some(&module) = self.modules.get(instance.module.as_str()) else {
            return refuse(instance.line, format!("no module `{}`", instance.module));
        };
        let mut parameters = HashMap::new();
        for (name, value) in &instance.parameters {
            let mut evaluator = self.evaluator(parent, Mode::Continuous);
            let signed = evaluator.shape(value)?.signed;
            let known = Known::new(evaluator.constant(value)?);
            parameters.insert(name.as_str(), (known, signed));
        }
        let place = Some((parent, instance.name.as_str()));
        let id = self.instance(module, place, parameters, depth + 1)?;
        let children = &mut self.flat.instances[parent].children;
        if children.insert(&instance.name, id).is_some() {
            return refuse(instance.line, format!("`{}` is there twice", instance.name));
        }
        let mut ports: HashMap<&str, (SignalId, Direction)> = HashMap::new();
        for name in &module.ports {
            ports.insert(name, self.port(id, module, name)?);
        }
        for (name, expression) in &instance.connections {
            let Some((port, direction)) = ports.remove(name.as_str()) else {
                let found = format!("`{}` has no port `{name}`, or it is taken", instance.module);
                return refuse(instance.line, found);
            };
            let Some(expression) = expression else {
                continue;
            };
            self.check_port_width(parent, port, expression)?;
            match direction {
                Direction::Input => {
                    self.drive_whole(port, parent, expression, expression.line)?;
                }
                Direction::Output => self.output(parent, port, expression)?,
            }
        }
        Ok(())
    }

    /// Checks that a port has the width of its connection. Icarus evaluates an expression on a port at its
    /// own width, other simulators at the port's.
    fn check_port_width(
        &mut self,
        parent: usize,
        port: SignalId,
        expression: &'a Expression,
    ) -> Result<(), Refusal> {
        let mut evaluator = self.evaluator(parent, Mode::Continuous);
        let given = evaluator.shape(expression)?.width;
        let signal = self.flat.signal(port);
        let (name, width) = (signal.name, signal.width);
        match given == width {
            true => Ok(()),
            false => refuse(
                expression.line,
                format!("{given} bits on `{name}`, which has {width}"),
            ),
        }
    }

    /// Connects an output to its target outside.
    fn output(
        &mut self,
        parent: usize,
        port: SignalId,
        target: &'a Expression,
    ) -> Result<(), Refusal> {
        let mut names = Vec::new();
        target_names(target, &mut names);
        if names.is_empty() {
            return refuse(target.line, "an output on no signal".to_owned());
        }
        let mut evaluator = self.evaluator(parent, Mode::Continuous);
        let parts = evaluator.net_targets(target)?;
        let width = parts.iter().map(|part| part.2).sum();
        let value = self.flat.read(port);
        let signed = self.flat.signal(port).signed;
        let value = self.flat.graph.resize(value, width, signed);
        self.drive_parts(&parts, value, target.line)?;
        let mut environment = Environment::new(Mode::Continuous);
        environment.reads.push(port);
        self.unit(
            environment,
            parts.iter().map(|part| part.0).collect(),
            false,
        );
        Ok(())
    }
}
